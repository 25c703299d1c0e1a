// A Parallax Eddie on a cable: what its board answers to readings, wheel speeds to GOSPD. Protocol, sources
// and what is doubtful: components/robot_base/eddie/README.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/robot_base/driver.hpp"
#include "components/robot_base/eddie/command_check.hpp"
#include "components/robot_base/eddie/dialogue.hpp"
#include "components/robot_base/eddie/eddie_options.hpp"
#include "components/robot_base/eddie/text.hpp"
#include "components/robot_base/held_report.hpp"
#include "components/robot_base/unknown_device.hpp"

namespace bw::eddie {

/// poll() reads, command() writes, at most one request at a time. The first thing written after an opening,
/// and after a long silence, is STOP 0; nothing but the questions and settings of the start follows until the
/// board answered all of them.
class Eddie : public Driver {
 public:
  Eddie(const EddieOptions& options, const Robot& robot, std::unique_ptr<ByteLink> link);

  Readings poll(Time now) override;
  bool command(Time now, const WheelSpeeds& wheels) override;
  /// Makes the board stand, whatever it does: twice, because in the middle of a line the first one makes that
  /// an error, which moves nothing.
  static std::vector<std::uint8_t> stop_frame();
  /// Does not wait for a reply that is due: the board's buffer holds both lines, and the process ends.
  void stop(Time now) override;
  std::vector<Ranger> rangers() const override;
  std::map<std::string, std::uint64_t> counters() const override;
  BaseFacts facts() const override;

 private:
  enum class Phase { closed, opened, starting, running };
  struct Target {
    int left = 0, right = 0;  ///< as GOSPD counts
    bool operator==(const Target&) const = default;
  };
  struct Task {
    Request request;
    Duration period;
    std::optional<Time> asked;
  };

  void begin_session(Time now);
  void take(Time now, const Reply& reply, Readings& readings);
  void take_start(Time now, const Reply& reply);
  void take_mark(Time now, bool has_reason);
  bool take_running(Time now, const Reply& reply, Readings& readings);
  bool take_counts(Time now, const Reply& reply, Readings& readings);
  bool take_analog(const Reply& reply, Readings& readings) const;
  bool take_sonar(const Reply& reply, Readings& readings) const;
  void refused(Time now, const Reply& reply, const std::string& reason);
  LinkState heard(Time now, const LinkState& cable);
  void tell(Time now, Readings& readings);

  std::vector<Request> start_sequence() const;
  std::string text_of(Request request) const;
  Target target_of(const WheelSpeeds& wheels) const;
  WheelSpeeds ground_speeds(const Target& target) const;
  std::optional<Request> next(Time now);

  EddieOptions options_;
  WheelSpeeds metres_per_count_;
  bool is_coarse_ = false;  ///< the older board, with fewer positions to a revolution
  double reach_;            ///< [m/s] beyond which no wheel rotates
  std::unique_ptr<ByteLink> link_;
  std::uint64_t openings_ = 0;
  Phase phase_ = Phase::closed;
  Time began_;
  std::size_t start_step_ = 0;
  std::optional<Time> heard_;  ///< the newest sound reply
  Dialogue dialogue_;
  CommandCheck check_;
  UnknownDevice unknown_device_;
  std::vector<Task> tasks_;
  Target target_, sent_;
  bool was_sent_ = false;
  std::optional<Distances> distances_;
  Time distances_time_;
  bool is_marked_ = false;      ///< the board told the reason of an error: it knows of our VERB 1
  bool has_restarted_ = false;  ///< since the newest distances
  Distances base_;              ///< added to the board's, so that counts go on over its restart
  bool has_watch_ = true;
  int drive_refusals_ = 0;
  std::string settings_refused_;
  HeldReport faults_;
  std::uint64_t errors_ = 0, malformed_ = 0, jumps_ = 0, starts_ = 0, contradictions_ = 0, restarts_ = 0;
  std::optional<std::uint32_t> version_, hardware_;
};

}  // namespace bw::eddie
