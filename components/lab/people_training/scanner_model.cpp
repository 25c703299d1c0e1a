#include "components/lab/people_training/scanner_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::people {
namespace {

constexpr double kEdge = 0.1;        // neighbours farther apart are an edge [m],
constexpr double kEchoLength = 1.2;  // and if farther than this the first echo alone is told [m]

struct ScannerProduct {
  int beams;
  double field_of_view;
  double range_max;
  double rate;
  bool triangulates;  ///< its noise grows with the range
};

// From 0.25 to 1 degree between beams.
constexpr std::array<ScannerProduct, 8> kScannerProducts = {
    {{360, 2.0 * std::numbers::pi * 359 / 360, 12.0, 5.5, true},
     {450, 2.0 * std::numbers::pi * 449 / 450, 12.0, 10.0, true},
     {512, std::numbers::pi, 5.6, 10.0, false},
     {541, 1.5 * std::numbers::pi, 20.0, 25.0, false},
     {720, 1.5 * std::numbers::pi, 10.0, 10.0, false},
     {720, 2.0 * std::numbers::pi * 719 / 720, 16.0, 20.0, true},
     {1081, 1.5 * std::numbers::pi, 30.0, 40.0, false},
     {1440, 2.0 * std::numbers::pi * 1439 / 1440, 25.0, 10.0, false}}};

void mix_edges(LaserScan& scan, double share, Random& random) {
  for (std::size_t i = 0; i + 1 < scan.ranges.size(); ++i) {
    const double a = scan.ranges[i];
    const double b = scan.ranges[i + 1];
    const double gap = std::abs(a - b);
    if (!std::isfinite(a) || !std::isfinite(b) || gap < kEdge || gap > kEchoLength) continue;
    const bool mixed = random.uniform() < share;
    const std::size_t which = random.uniform() < 0.5 ? i : i + 1;
    const double range = std::min(a, b) + random.uniform() * gap;
    if (!mixed) continue;
    scan.ranges[which] = static_cast<float>(range);
    ++i;  // an edge makes one mixed pixel
  }
}

}  // namespace

ScannerModel draw_scanner(Random& random, bool varied) {
  ScannerModel model;
  model.laser.range_max = 10.0;
  model.laser.range_noise = 0.0;
  if (!varied) return model;
  const ScannerProduct& sold =
      kScannerProducts[static_cast<std::size_t>(random.uniform() * kScannerProducts.size())];
  model.laser.rate = sold.rate;
  model.laser.beams = sold.beams;
  model.laser.field_of_view = sold.field_of_view;
  model.laser.range_max = sold.range_max;
  model.noise = sold.triangulates ? random.uniform(0.001, 0.005) : random.uniform(0.004, 0.03);
  model.noise_share = sold.triangulates ? random.uniform(0.002, 0.01) : 0.0;
  model.cloth = random.uniform(0.0, 0.012);
  model.mixed = random.uniform(0.0, 0.5);
  model.lost = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 0.04);
  model.lost_beams_say_so = random.uniform() < 0.5;
  model.step = random.uniform() < 0.5 ? 0.001 : 0.01;
  return model;
}

LaserScan as_measured(const LaserScan& exact, const std::vector<std::uint8_t>& on_leg,
                      const ScannerModel& model, Random& random) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  LaserScan scan = exact;
  mix_edges(scan, model.mixed, random);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double error = random.normal();
    const double luck = random.uniform();
    if (!std::isfinite(scan.ranges[i])) continue;
    if (on_leg[i] != 0 && luck < model.lost) {
      scan.ranges[i] = model.lost_beams_say_so ? std::numeric_limits<float>::quiet_NaN() : kInfinity;
      continue;
    }
    double range = scan.ranges[i];
    const double sigma =
        std::hypot(model.noise + model.noise_share * range, on_leg[i] != 0 ? model.cloth : 0.0);
    range += sigma * error;
    if (model.step > 0.0) range = model.step * std::round(range / model.step);
    scan.ranges[i] = range > model.laser.range_max   ? kInfinity
                     : range < model.laser.range_min ? -kInfinity
                                                     : static_cast<float>(range);
  }
  return scan;
}

}  // namespace bw::people
