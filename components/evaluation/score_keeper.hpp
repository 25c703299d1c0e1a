// The run in numbers, kept from the world's truth alone: what the robot believes plays no part, except that
// it must claim the goal.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "components/evaluation/rms_jerk.hpp"
#include "components/evaluation/truth_sample.hpp"
#include "components/model/footprint.hpp"
#include "components/model/goal_tolerance.hpp"
#include "runtime/base/field.hpp"

namespace bw {

/// The closest the robot came to a person.
struct Encounter {
  double time = 0.0;                                     ///< since the start of the drive [s]
  double gap = std::numeric_limits<double>::infinity();  ///< boundary to boundary [m]; negative: overlapping
  std::uint32_t person = 0;
  Vector2 person_position{0.0, 0.0};
  double person_radius = 0.0;
  Pose2 X_MB;
};

struct ScoreCard {
  bool finished = false;
  bool reached = false;          ///< claimed, and truly within the judge's tolerance; of several goals, each
  bool is_outcome_known = true;  ///< false: the robot claims it, and where it truly was nobody tells
  std::string reason;
  double time_to_goal = 0.0;      ///< since the start of the drive; of a goal not reached, the time spent [s]
  double path_length = 0.0;       ///< truly driven [m]
  double distance_to_goal = 0.0;  ///< of the last sample [m]
  double min_distance =
      std::numeric_limits<double>::infinity();  ///< boundary to boundary, people and walls [m]
  int collisions = 0;                           ///< contacts; one lasts until the bodies are 2 cm apart
  int collisions_at_speed = 0;                  ///< those during which the robot moved faster than 0.1 m/s
  double max_collision_index = 0.0;             ///< sigma 0.6 m
  double max_collision_index_045 = 0.0;         ///< sigma 0.45 m
  double share_ci_above_0_54 = 0.0;             ///< of the time, sigma 0.6 m
  double share_ci_above_0_14 = 0.0;
  double mean_speed = 0.0;  ///< path length over time [m/s]
  double rms_jerk = 0.0;    ///< see rms_jerk.hpp [m/s^3]
  std::optional<Encounter> closest;
};

struct EvaluationOptions {
  double goal_tolerance = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("goal_tolerance", goal_tolerance,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc = "a goal claimed from farther away than this is not counted as reached; 0: 0.1 m more than the "
              "navigator's xy_tolerance"});
  }
};

class ScoreKeeper {
 public:
  ScoreKeeper(const EvaluationOptions& options, Footprint robot)
      : options_(options), footprint_(std::move(robot)) {}

  /// Opens a fresh card; the drive lasts until finish(). `tolerance`: the navigator's.
  void start(Time now, const Vector2& goal, const GoalTolerance& tolerance = {});
  /// A goal of the drive that others follow is over.
  void end_leg(bool claimed);
  /// The goal after it.
  void next_leg(const Vector2& goal, const GoalTolerance& tolerance) {
    goal_ = goal;
    tolerance_ = tolerance;
    card_.reached = false;
    card_.reason.clear();
  }
  /// The goal in hand is over and the card goes on: its outcome stands on it until the next goal or close().
  void end_goal(bool claimed, const std::string& reason) { settle(claimed, reason); }
  /// Ends the card with the outcome that stands on it.
  void close();
  /// Counts while a drive lasts. Samples that are not newer, or whose positions are not finite, are ignored;
  /// without a speed (NaN) there is no jerk.
  void add(const TruthSample& sample);
  /// `claimed`: the robot says that it stands at the goal.
  void finish(Time now, bool claimed, const std::string& reason);

  /// The truth of the last sample holds no more, and until the next one nobody knows where the robot is.
  void lose_pose() { knows_pose_ = false; }

  /// The robot's outline from now on.
  void set_footprint(const Footprint& footprint) { footprint_ = footprint; }

  bool running() const { return running_; }
  const ScoreCard& card() const { return card_; }
  const Vector2& goal() const { return goal_; }
  Time started() const { return started_; }

 private:
  struct Contact {
    bool at_speed = false;
  };

  /// Nothing: nobody knows.
  std::optional<bool> is_there(bool claimed) const;
  void settle(bool claimed, const std::string& reason);
  void count_contacts(const TruthSample& sample);
  void touch(std::int64_t key, double gap, bool fast);

  EvaluationOptions options_;
  Footprint footprint_;
  bool running_ = false;
  bool missed_a_leg_ = false;
  bool has_unknown_leg_ = false;
  bool knows_pose_ = false;
  ScoreCard card_;
  Vector2 goal_{0.0, 0.0};
  GoalTolerance tolerance_;
  Time started_;
  std::optional<TruthSample> last_;
  RmsJerk jerk_;
  double time_measured_ = 0.0;
  double time_above_0_54_ = 0.0;
  double time_above_0_14_ = 0.0;
  std::map<std::int64_t, Contact> touching_;  ///< by person id; walls as kWall
  int seen_contacts_ = 0;
  int seen_contacts_at_speed_ = 0;
  int world_contacts_ = 0;
  int world_contacts_at_speed_ = 0;
};

}  // namespace bw
