// Whether the base is heard, and hears: its counts come, and commands get through to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/byte_link.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct LinkOptions {
  double silence = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("silence", silence,
      {.unit = "s",
       .min = 0.03,
       .max = 1,
       .doc = "without counts, or with commands that do not get through, for so long: the base is lost"});
  }
};

enum class LinkHealth {
  unheard,   ///< never heard so far
  heard,     ///< all is well
  lost,      ///< it was heard, and is not
  reopened,  ///< the device was opened anew since the last look: whatever it was told is forgotten
};

class LinkGuard {
 public:
  explicit LinkGuard(const LinkOptions& options) : silence_(Duration::seconds(options.silence)) {}

  /// What a poll of the driver told; `has_counts`: how the wheels rotated was among it.
  void read(Time now, const LinkState& link, bool has_counts);
  /// Whether the last command got through.
  void told(Time now, bool is_through);
  LinkHealth look(Time now) {
    const LinkHealth health = judge(now);
    if (health == LinkHealth::unheard && (link_.is_opening || is_beginning(now))) reason_.clear();
    return health;
  }
  /// Why it is not heard, for people; empty also while its cable is being opened and in the first second: a
  /// base may take its time to begin.
  const std::string& reason() const { return reason_; }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  LinkHealth judge(Time now);
  bool is_beginning(Time now);

  Duration silence_;
  LinkState link_;
  std::uint64_t openings_ = 0;  ///< as of the last look
  std::optional<Time> first_look_;
  std::optional<Time> heard_;
  std::optional<Time> refused_since_;
  std::string reason_;
};

}  // namespace bw
