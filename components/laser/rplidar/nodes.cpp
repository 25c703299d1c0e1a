#include "components/laser/rplidar/nodes.hpp"

#include <algorithm>
#include <numbers>

namespace bw::laser {
namespace {

constexpr int kRevolution = 360 * 64;  // [1/64 degree]
constexpr int kMaxAdvance = 20 * 64;   // from node to node: a standard scan has 1 to 2 degrees
constexpr int kMaxReturn = 3 * 64;     // angles tremble
constexpr int kAngleLimit = 361 * 64;  // firmware rounds up to a whole revolution

constexpr std::size_t kRow = 3 * kNodeSize;        // that must fit to be in step again
constexpr std::size_t kLookBack = 10 * kNodeSize;  // a wall's range may pass for an angle over 4 degrees

bool follows(const Node& before, const Node& node) {
  const int advance = (node.angle_q6 - before.angle_q6 + 2 * kRevolution) % kRevolution;
  return advance <= kMaxAdvance || advance >= kRevolution - kMaxReturn;
}

std::optional<Node> node_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return read_node(bytes.subspan(at).first<kNodeSize>());
}

}  // namespace

double Node::angle() const { return angle_q6 * (std::numbers::pi / (180.0 * 64.0)); }

std::optional<Node> read_node(std::span<const std::uint8_t, kNodeSize> bytes) {
  const bool starts = (bytes[0] & 1) != 0;
  const bool starts_not = (bytes[0] & 2) != 0;
  const int angle = (bytes[1] | bytes[2] << 8) >> 1;
  if (starts == starts_not || (bytes[1] & 1) == 0 || angle > kAngleLimit) return std::nullopt;
  return Node{.starts_revolution = starts,
              .quality = static_cast<std::uint8_t>(bytes[0] >> 2),
              .angle_q6 = static_cast<std::uint16_t>(angle),
              .range_q2 = static_cast<std::uint16_t>(bytes[3] | bytes[4] << 8)};
}

void NodeReader::begin() {
  bytes_.clear();
  next_ = 0;
  in_step_ = true;
  last_.reset();
}

void NodeReader::read(std::span<const std::uint8_t> bytes, std::vector<Node>& nodes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  while (take_one(nodes)) {
  }
  forget();
}

bool NodeReader::take_one(std::vector<Node>& nodes) {
  if (!in_step_ && !find_step()) return false;
  if (bytes_.size() - next_ < kNodeSize) return false;
  const auto node = node_at(bytes_, next_);
  if (!node || (last_ && !follows(*last_, *node))) {
    in_step_ = false;
    candidate_ = next_ - std::min(next_, kLookBack);
    ++counters_.losses_of_step;
    return true;
  }
  next_ += kNodeSize;
  ++counters_.nodes;
  last_ = node;
  nodes.push_back(*node);
  return true;
}

bool NodeReader::find_step() {
  for (;; ++candidate_) {
    if (candidate_ > next_) {
      next_ = candidate_;
      ++counters_.bytes_thrown_away;
    }
    const Row row = row_at(candidate_);
    if (row == Row::breaks) continue;
    if (row == Row::goes_on) return false;
    in_step_ = true;
    next_ = candidate_;
    last_.reset();
    return true;
  }
}

/// Fits: so many nodes in a row follow each other, over the position where step was lost and a node further.
/// What was read in step until there breaks there again, so that nothing is read twice.
NodeReader::Row NodeReader::row_at(std::size_t at) const {
  const std::size_t end = std::max(at + kRow, next_ + kNodeSize);
  std::optional<Node> before;
  for (; at < end; at += kNodeSize) {
    if (bytes_.size() < at + kNodeSize) return Row::goes_on;
    const auto node = node_at(bytes_, at);
    if (!node || (before && !follows(*before, *node))) return Row::breaks;
    before = node;
  }
  return Row::fits;
}

void NodeReader::forget() {
  const std::size_t oldest = in_step_ ? next_ - std::min(next_, kLookBack) : candidate_;
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(oldest));
  next_ -= oldest;
  candidate_ = 0;
}

}  // namespace bw::laser
