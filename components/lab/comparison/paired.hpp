// Whether two ways of driving differ, told from the same episodes driven by both (evaluation/theory.md 8.12).
//
// McNemar, exact (McNemar 1947): among the episodes in which just one of the two succeeded each is as likely
// to be that one, if they are equally good, so the two-sided p is that of a fair coin: min(1, 2 P(X <= min(b,
// c))), X ~ Bin(b + c, 1/2).
//
// Interval of a mean: bootstrap (Efron 1979), percentiles 2.5 and 97.5 of the means of 10,000 samples drawn
// with replacement.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bw {

/// Two-sided p of `b` successes of one alone and `c` of the other; 1 without any.
double mcnemar_p(int b, int c);

inline constexpr int kBootstrapSamples = 10'000;
inline constexpr std::uint64_t kBootstrapSeed = 1;

/// A mean and its interval at 95 %; NaN without values.
struct MeanInterval {
  int count = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// The same values give the same interval: every call draws from kBootstrapSeed. Values that are not finite
/// are left out.
MeanInterval bootstrap_mean(const std::vector<double>& values);

/// What two ways of driving are compared by, of one episode. Figures are NaN where they were not measured.
struct PairedEpisode {
  std::string key;  ///< the same for the same episode, unique among those of one way of driving
  bool success = false;
  bool possible = true;          ///< success was (possible/theory.md 8.10)
  double collision_index = 0.0;  ///< the largest, evaluation/theory.md 7.7
  double closest = 0.0;          ///< [m]
  double jerk = 0.0;             ///< [m/s^3]
  double time = 0.0;             ///< [s]
};

struct Comparison {
  int pairs = 0;         ///< episodes that both drove
  int only_first = 0;    ///< c: succeeded by the first alone
  int only_second = 0;   ///< b: by the second alone
  double p = 1.0;        ///< mcnemar_p
  MeanInterval success;  ///< share of the pairs, second less first
  int both = 0;          ///< succeeded by both; of these, second less first:
  MeanInterval collision_index, closest, jerk, time;
};

Comparison compare(const std::vector<PairedEpisode>& first, const std::vector<PairedEpisode>& second);

}  // namespace bw
