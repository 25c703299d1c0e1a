// The emergency stop: who has pressed it, whether a button that has to be heard is silent, and whether it may
// be released. It is latched for each writer by itself: `false` lifts the writer's own button and no other,
// and only a release lets the base drive again.
//
//   stop.hear(now, writer, node, is_pressed);     // each message
//   stop.step(now);                               // while the base is active
//   if (const auto why_not = stop.refusal(lease_of)) ... else text = stop.release();
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct StopButtonOptions {
  std::string node = "/panel";
  double heartbeat = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("node", node,
      {.doc = "full name of the node that publishes emergency_stop, pressed or not, at a steady rate"});
    v("heartbeat", heartbeat,
      {.unit = "s",
       .min = 0.05,
       .max = 10,
       .doc = "silent for longer it counts as pressed; at least two periods of its messages"});
  }
};

struct EmergencyStopOptions {
  std::vector<StopButtonOptions> buttons;

  template <class Visitor>
  void fields(Visitor& v) {
    v("buttons", buttons, {.doc = "those that have to be heard; others may press as well, and leave"});
  }
  std::optional<std::string> violated_rule() const;
};

class EmergencyStop {
 public:
  using Writer = std::array<std::uint8_t, 16>;  ///< its GID
  /// For how long it counts as there when its process is killed; nothing: it has left.
  using LeaseOf = std::function<std::optional<Duration>(const Writer&)>;
  using NodeOf = std::function<std::string(const Writer&)>;  ///< empty: not named yet

  struct Pressed {
    Writer writer{};
    std::string node;  ///< full name; empty: not known
    Time since;
    bool operator==(const Pressed&) const = default;
  };
  /// What outlives the process while it is latched.
  struct Record {
    std::string cause;             ///< what latched it, for people; empty: it is not latched
    std::vector<Pressed> pressed;  ///< the buttons that are down
    bool operator==(const Record&) const = default;
  };

  /// Listed buttons have to be heard from `now` on, within their heartbeat.
  void begin(Time now, const EmergencyStopOptions& options);
  /// Latched as another process left it.
  void restore(Record record) { record_ = std::move(record); }

  /// A message; `node` is the full name of the writer's node, empty when it is not known.
  void hear(Time now, const Writer& writer, const std::string& node, bool is_pressed);
  /// Listed buttons that are silent press. Every few milliseconds while the base is active.
  void step(Time now);
  /// Names that came after their message.
  void name(const NodeOf& node_of);

  bool is_latched() const { return !record_.cause.empty(); }
  /// For people; empty when it is not latched.
  std::string reason() const;
  const Record& record() const { return record_; }
  /// Why a release is refused, and for how long one who was killed refuses it. Who has left with the button
  /// pressed does not refuse it.
  std::optional<std::string> refusal(const LeaseOf& lease_of) const;
  /// Lets go; says who had pressed and has left. Not while refusal() has an answer.
  std::string release();

 private:
  struct Button {
    StopButtonOptions options;
    Time heard;
    bool is_silent = false;
  };

  std::vector<Button> buttons_;
  Record record_;
};

}  // namespace bw
