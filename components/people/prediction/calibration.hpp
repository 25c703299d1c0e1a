// Are predicted ellipses as large as they should be? Each prediction is compared with what the person did;
// the size of the ellipses follows so that a share of them holds the truth (adaptive conformal inference,
// Gibbs and Candes 2021: a step up for every truth outside, a small one down for every truth inside). One
// size for each step ahead, shared by everybody.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "components/model/obstacles.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

class Calibration {
 public:
  /// `rate`: step of the logarithm of the size for a truth outside; 0 leaves all sizes at 1.
  explicit Calibration(double rate) : rate_(rate) {}

  /// Factor for covariances of the k-th step ahead, 1/16 to 16.
  double size(std::size_t k) const;

  /// `predictions` of a person at `now` before sizes were applied; kept until they come true, one set for
  /// each `step`.
  void expect(std::uint32_t id, Time now, const std::vector<PredictedPosition>& predictions);
  /// Where the person is `now`, with what is not known of that.
  void observe(std::uint32_t id, Time now, const Vector2& position, const Eigen::Matrix2d& covariance);
  /// Forgets people not seen since `before`; sizes stay.
  void forget(Time before);

 private:
  struct Expected {
    Time made;
    std::vector<PredictedPosition> predictions;
    std::size_t next = 0;  ///< first that has not come true
  };
  struct Person {
    Time seen;
    Vector2 position{0.0, 0.0};
    std::vector<Expected> expected;
  };

  void compare(std::size_t k, const PredictedPosition& predicted, const Vector2& truth,
               const Eigen::Matrix2d& covariance);

  double rate_;
  std::vector<double> log_size_;
  std::map<std::uint32_t, Person> people_;
};

}  // namespace bw::people
