#include "components/laser/revolution.hpp"

#include <numbers>
#include <utility>

#include "runtime/base/pose2.hpp"

namespace bw::laser {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMaxSamples = 20'000;  // a head that stands sends nodes all the same

}  // namespace

void RevolutionCollector::restart() {
  is_whole_ = false;
  revolved_ = 0.0;
  last_angle_.reset();
  collected_ = {};
}

std::optional<Revolution> RevolutionCollector::add(const Node& node, Time time) {
  const double angle = wrap_angle(node.angle());  // of the device: the rear is where it jumps from pi to -pi
  const double advance = last_angle_ ? wrap_angle(angle - *last_angle_) : 0.0;
  // Angles tremble: only what rotated by half at least has come round when it passes the rear.
  const bool passes_rear = last_angle_ && *last_angle_ > 0.0 && angle <= 0.0 && advance > 0.0 &&
                           advance<kPi&& * last_angle_ + advance> kPi;
  const bool is_over = passes_rear && (!is_whole_ || revolved_ > kPi);
  std::optional<Revolution> over;
  if (is_over) {
    collected_.next = time;
    if (is_whole_) over = std::exchange(collected_, {});
    collected_ = {.first = time, .is_clockwise = !is_upside_down_};
    is_whole_ = true;
    revolved_ = 0.0;
  } else {
    revolved_ += advance;
  }
  last_angle_ = angle;
  start_bits_ += node.starts_revolution ? 1 : 0;
  if (collected_.samples.size() >= kMaxSamples) restart();
  double seen_at = wrap_angle(is_upside_down_ ? angle : -angle);
  if (seen_at >= kPi) seen_at = -kPi;
  if (is_whole_) collected_.samples.push_back({seen_at, node.range(), node.quality});
  return over;
}

}  // namespace bw::laser
