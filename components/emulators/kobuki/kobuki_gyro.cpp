#include "components/emulators/kobuki/kobuki_gyro.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bw::emulators {
namespace {

constexpr double kDegreesPerDigit = 0.00875;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::size_t kMaxSamples = 3;  // that a packet holds
constexpr double kLargest = 32767.0;

int digits(double value) { return static_cast<int>(std::lround(std::clamp(value, -kLargest, kLargest))); }

}  // namespace

KobukiGyro::KobukiGyro(const KobukiGyroOptions& options, std::uint64_t seed)
    : options_(options),
      random_(seed),
      to_next_sample_(1.0 / options.sample_rate),
      angle_(options.first_angle) {}

void KobukiGyro::step(double rate, double dt) {
  const double felt = rate * kDegrees * (1.0 + options_.scale_error);
  rate_ = felt + options_.drift;
  angle_ = std::remainder(angle_ + rate_ * dt, 360.0);
  for (to_next_sample_ -= dt; to_next_sample_ <= 0.0; to_next_sample_ += 1.0 / options_.sample_rate) {
    const auto raw = [&](double true_rate) {
      return digits((true_rate + options_.bias + random_.normal(0.0, options_.noise)) / kDegreesPerDigit);
    };
    const int x = raw(0.0);
    const int y = raw(0.0);
    samples_.push_back({x, y, raw(felt)});
    ++frame_id_;
  }
  if (samples_.size() > kMaxSamples)
    samples_.erase(samples_.begin(), samples_.end() - static_cast<std::ptrdiff_t>(kMaxSamples));
}

std::vector<RawGyroSample> KobukiGyro::take_samples() { return std::exchange(samples_, {}); }

int KobukiGyro::angle_in_hundredths() const { return digits(angle_ * 100.0); }
int KobukiGyro::rate_in_hundredths() const { return digits(rate_ * 100.0); }

}  // namespace bw::emulators
