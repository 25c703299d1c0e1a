// Every contact with somebody in a drive: when, with whom, who hit whom, and since when they were there.
// Values in, values out; contacts begin and end by the rule of the score card (score_keeper.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "components/evaluation/truth_sample.hpp"
#include "components/evaluation/who_hit_whom.hpp"
#include "components/model/footprint.hpp"

namespace bw {

struct ContactRecord {
  double time = 0.0;  ///< of the first touch, since the start of the drive [s]
  double end = 0.0;   ///< of the last sample in contact [s]
  std::uint32_t person = 0;
  bool at_speed = false;     ///< at some time of it the robot moved faster than kStandingSpeed
  Closing closing;           ///< at the first touch
  double there_since = 0.0;  ///< first sample with the person [s]; 0: since the drive began
  bool begins_mid_floor =
      false;  ///< they came to be less than a second before the touch, after the drive began
  bool ends_mid_floor = false;  ///< and were gone less than a second after it, while the drive went on
};

/// Newer people, and those who go sooner, are recordings that begin or end in mid-floor [s].
inline constexpr double kMidFloor = 1.0;

class ContactDiary {
 public:
  /// `time` of the sample is since the start of the drive [s]; it rises. Samples that are not sound are left
  /// out.
  void add(double time, const TruthSample& sample, const Footprint& robot);
  /// In the order of their beginnings.
  const std::vector<ContactRecord>& contacts() const { return contacts_; }

 private:
  struct Look {
    double time = 0.0;
    Pose2 pose;
    double v = 0.0;
  };

  void note_leaving(double time, const TruthSample& sample);
  void touch(double time, const TruthSample& sample, const TruePerson& person, const Twist2& twist,
             double gap, bool is_fast);

  std::optional<double> began_;
  std::optional<Look> last_;
  std::map<std::uint32_t, double> there_since_;  ///< who is there
  std::map<std::uint32_t, std::size_t> touching_;
  std::vector<ContactRecord> contacts_;
};

}  // namespace bw
