#include "components/evaluation/axis_ticks.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

constexpr double kRounding = 1e-9;  // of a step: sums of steps miss the ends by less

}  // namespace

double round_step(double low, double high, int most) {
  const double smallest = (high - low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(smallest) + kRounding));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest * (1.0 - kRounding)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> ticks_between(double low, double high, double step) {
  std::vector<double> ticks;
  const auto first = static_cast<long>(std::ceil(low / step - kRounding));
  const auto last = static_cast<long>(std::floor(high / step + kRounding));
  for (long i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

double round_end(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double step = round_step(0.0, value, 5);
  return std::ceil(value / step - kRounding) * step;
}

std::vector<double> decades_between(double low, double high) {
  std::vector<double> ticks;
  const double last = std::log10(high) + kRounding;
  for (double power = std::ceil(std::log10(low) - kRounding); power <= last; power += 1.0)
    ticks.push_back(std::pow(10.0, power));
  return ticks;
}

std::string tick_text(double value, double step) {
  const int decimals = static_cast<int>(std::max(0.0, std::ceil(-std::log10(step) - kRounding)));
  return fixed(value, decimals);
}

}  // namespace bw
