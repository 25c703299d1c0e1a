// How old is what a stamp tells? Stamps of the own clock say so: age = now - stamp, a constant delay
// included. Of another clock only differences can be trusted:
//
//   age = (arrival - stamp) - least + delay,   least = min over samples of (arrival - stamp), which follows a drift of 500 ppm
//
// with the delay that somebody measured: one that is always there is in the least and cannot be seen. The
// least rises only while samples keep close to it, as those of a slow clock do; what is later than that stays
// late, however long it does.
//
//   earlier than the least   the other clock was set forward, or all before were late: begun anew
//   stamps that go back      overtaken or sent twice, unless new ones stay so, constant, for a second: then the clock was set back
//   silence                  of 10 s and more outlasts any queue: what differs afterwards for a second is a clock that was set
//
// What was late for a second before a clock was set is as late after it. After a beginning nothing is
// believed for a second in which no sample comes sooner than those before: a queue that drains is no clock. A
// clock that is set forward while samples are late, by less than they are, hides so much of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw {

enum class StampFault : std::uint8_t {
  none,
  late,       ///< older than the limit
  future,     ///< of the own clock, and not yet
  overtaken,  ///< older than one of the same writer that came before
  unproven,   ///< of another clock that is not known yet, or was set
};
const char* to_text(StampFault fault);

struct StampAge {
  Duration age;  ///< never negative; of no use while the clock is unproven
  StampFault fault = StampFault::none;
  bool has_stepped = false;  ///< this sample proved that the other clock was set
};

/// What another clock's samples say of it, one writer.
class ForeignClock {
 public:
  static constexpr double kDriftMax = 5e-4;
  static constexpr Duration kNear =
      Duration::milliseconds(50);  ///< of the least: a clock that drifts keeps so close
  static constexpr Duration kSooner = Duration::milliseconds(20);  ///< than the least: no jitter
  static constexpr Duration kProof = Duration::milliseconds(1000);
  static constexpr Duration kSilence = Duration::milliseconds(10'000);
  static constexpr int kEnough = 4;  ///< samples of a proof

  enum class Delivery : std::uint8_t {
    queued,  ///< samples may wait on their way, for as long as they like
    direct  ///< nothing holds them back for long, as on a serial line: what is late for a second is a clock that was set
  };

  explicit ForeignClock(Delivery delivery = Delivery::queued) : delivery_(delivery) {}

  /// `now` rises; if it does not, all is begun anew.
  StampAge add(Time now, Time stamp);
  /// What is added to a stamp to get the time on the own clock.
  Duration least() const { return least_; }
  bool is_proven() const { return is_proven_; }

 private:
  /// Samples that may be of a clock that was set.
  struct Run {
    Duration first, least;
    Time since;
    int samples = 0;
  };

  void begin(Time now, Time stamp, Duration known_age);
  void follow_drift(Time now);
  bool is_repeated(Time stamp);
  static bool proves(Run& run, Time now, Duration lag);
  StampAge after_jump(Time now, Time stamp, StampAge seen, Duration known_age);

  Delivery delivery_;
  bool is_begun_ = false;
  bool is_proven_ = false;
  Run proof_;
  std::optional<Run> jump_;
  Duration least_;
  Time heard_;                    ///< newest arrival
  Time near_;                     ///< newest arrival close to the least
  std::optional<Duration> late_;  ///< least age since then
  Duration age_before_jump_;
  Time newest_stamp_;
  std::array<Time, 64> seen_stamps_{};
  std::size_t next_seen_ = 0;
};

/// Whose stamp it is.
struct StampSource {
  std::array<std::uint8_t, 16> writer{};  ///< its GID
  bool is_own_clock = true;
  Duration delay{};  ///< of another clock's samples, constant, as measured
};

/// The stamps of all who write one topic.
class StampAges {
 public:
  static constexpr std::size_t kWriters = 16;  ///< the one that was silent longest is forgotten for a new one
  static constexpr Duration kFuture =
      Duration::milliseconds(50);  ///< clocks of one host, and ticks of /clock, are no closer

  /// `limit`: what is older is late. Repeated stamps are no fault.
  StampAge add(Time now, Time stamp, const StampSource& source, Duration limit);

 private:
  struct Writer {
    std::array<std::uint8_t, 16> id{};
    Time heard;
    bool is_own_clock = true;
    std::optional<Time> newest;  ///< stamp, of the own clock
    ForeignClock clock{ForeignClock::Delivery::queued};
  };
  Writer& writer_of(Time now, const StampSource& source);

  std::vector<Writer> writers_;
};

}  // namespace bw
