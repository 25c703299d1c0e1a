// The score cards of a recorded drive: from the world's truth where the bag has it, else from what the robot
// itself believed (its odometry) and saw (its tracks).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/evaluation/drive_judge.hpp"
#include "components/evaluation/judged_contact.hpp"
#include "components/model/limits.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct ScoredDrive {
  ScoreCard card;
  PoseErrors pose_errors;
  std::vector<JudgedContact> contacts;
  bool has_goal = true;     ///< false: nobody said where the robot goes, the whole bag is one drive
  bool is_measured = true;  ///< false: no truth of it is in the bag, and no figure is known
};

struct BagScore {
  std::string judged_by;           ///< a sentence: by which topics
  std::vector<std::string> notes;  ///< what could not be judged, or is an estimate
  std::vector<ScoredDrive> drives;
};

/// Of a robot with this outline; without `limits` contacts are not judged. Throws std::runtime_error when the
/// bag holds neither a truth nor an odometry.
[[nodiscard]] BagScore score_bag(const bag::Bag& recording, const Footprint& robot,
                                 const std::optional<Limits>& limits = std::nullopt);

}  // namespace bw
