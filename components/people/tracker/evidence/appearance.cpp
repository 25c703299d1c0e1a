#include "components/people/tracker/evidence/appearance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::people {
namespace {

constexpr double kSurest = 0.95;      // no score says more than this
constexpr double kLongestEach = 2.0;  // one stands for no more than so many of these times
constexpr float kDoubt = 2.0F;        // so many of a side say nothing yet
constexpr float kRemembered = 20.0F;  // so many of a side are remembered
constexpr double kOtherSides = 0.5;   // what a side adds to the one that says most, as a share

}  // namespace

void Appearance::add(double score, double bearing, double since) {
  const double p = std::clamp(score, 1.0 - kSurest, kSurest);
  const double revolutions = bearing / (2.0 * std::numbers::pi);
  const auto at =
      static_cast<std::size_t>((revolutions - std::floor(revolutions)) * static_cast<double>(kSides));
  Side& side = sides_[std::min(at, kSides - 1)];
  const auto weight = static_cast<float>(std::min(since / kEach, kLongestEach));
  const float keep = std::min(1.0F, (kRemembered - weight) / std::max(1.0F, side.weight));
  side.sum = keep * side.sum + weight * static_cast<float>(std::log(p / (1.0 - p)));
  side.weight = keep * side.weight + weight;
}

double Appearance::log_odds() const {
  double sum = 0.0;
  double strongest = 0.0;
  for (const Side& side : sides_) {
    const double mean = static_cast<double>(side.sum / (side.weight + kDoubt));
    sum += mean;
    if (std::abs(mean) > std::abs(strongest)) strongest = mean;
  }
  return std::clamp(strongest + kOtherSides * (sum - strongest), -kMax, kMax);
}

}  // namespace bw::people
