// How many solver iterations fit into a planning cycle: a time, turned into iterations by what those of the
// last cycles took. The planners count, the clock stays with the caller.
#pragma once

namespace bw {

class IterationBudget {
 public:
  /// Fewer give no band worth driving: the floor, unless `max_iterations` is lower still.
  static constexpr int kMinIterations = 10;

  /// `cycle_time` [s] that a cycle may take; `max_iterations` at most, however quick they are.
  IterationBudget(double cycle_time, int max_iterations);

  /// A cycle that spent `iterations` took `time` [s], everything included. One without iterations, or with a
  /// time that is none, says nothing.
  void observe(int iterations, double time);

  /// For the next cycle; max_iterations until something was observed.
  int iterations() const;

 private:
  double cycle_time_;
  int max_iterations_;
  // Running means over about ten cycles. The quotient of the means, not the mean of the quotients: a warm
  // cycle of three iterations is mostly other work and says little about those of a hard one.
  double mean_time_ = 0.0;
  double mean_iterations_ = 0.0;
};

}  // namespace bw
