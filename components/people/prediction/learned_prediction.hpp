// Predictions by the learned head while they prove right. Each person's are held against what the person did; who does
// otherwise is left to constant velocity until the head is right again.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "components/model/tracked_person.hpp"
#include "components/people/prediction/learned_head.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

class LearnedPrediction {
 public:
  explicit LearnedPrediction(HeadWeights weights) : weights_(std::move(weights)) {}

  /// Of `person`, at `now`: kAhead positions kAheadStep apart, in the frame of the person. Nothing of who is not seen now,
  /// was not long enough, or walked otherwise than predicted; nor where the head gives what is not finite (counted).
  std::optional<std::vector<PredictedPosition>> predict(const TrackedPerson& person, Time now);

  /// Forgets people not seen since `before`.
  void forget(Time before);

  /// Predictions that were not finite, so far.
  std::int64_t refused() const { return refused_; }

 private:
  struct Sight {
    Time time;
    Vector2 position;
  };
  struct Expected {
    Time due;
    PredictedPosition prediction;
  };
  struct Person {
    std::deque<Sight> sights;  ///< the last one last
    std::deque<Expected> expected;
    std::deque<double> residuals;  ///< squared, normalised: chi-square with two degrees of freedom each
  };

  static void see(Person& person, const TrackedPerson& tracked, Time now);
  static std::vector<Vector2> past_of(const Person& person, Time now);
  static bool proves_right(const Person& person);

  HeadWeights weights_;
  std::map<std::uint32_t, Person> people_;
  std::int64_t refused_ = 0;
};

}  // namespace bw::people
