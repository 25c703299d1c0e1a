#include "components/laser/rplidar/nodes.hpp"

#include <numbers>

namespace bw::laser {
namespace {

constexpr int kTurn = 360 * 64;        // [1/64 degree]
constexpr int kMostAdvance = 20 * 64;  // from node to node: a standard scan has 1 to 2 degrees
constexpr int kMostReturn = 3 * 64;    // angles tremble
constexpr int kAngleLimit = 361 * 64;  // firmware rounds up to a whole turn

bool follows(const Node& before, const Node& node) {
  const int advance = (node.angle_q6 - before.angle_q6 + 2 * kTurn) % kTurn;
  return advance <= kMostAdvance || advance >= kTurn - kMostReturn;
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
  waiting_.clear();
  in_step_ = true;
  last_.reset();
}

void NodeReader::read(std::span<const std::uint8_t> bytes, std::vector<Node>& nodes) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  taken_ = 0;
  while (take_one(nodes)) {
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(taken_));
}

bool NodeReader::take_one(std::vector<Node>& nodes) {
  if (!in_step_ && !find_step()) return false;
  if (waiting_.size() - taken_ < kNodeSize) return false;
  const auto node = read_node(std::span<const std::uint8_t, kNodeSize>(waiting_.data() + taken_, kNodeSize));
  if (!node || (last_ && !follows(*last_, *node))) {
    in_step_ = false;
    ++counters_.losses_of_step;
    return true;
  }
  taken_ += kNodeSize;
  ++counters_.nodes;
  last_ = node;
  nodes.push_back(*node);
  return true;
}

/// In step again where two nodes in a row are sound and the second follows the first: at a wrong place one in sixteen pairs has
/// the right bits by chance, and hardly one in three hundred the right angles too.
bool NodeReader::find_step() {
  for (; waiting_.size() - taken_ >= 2 * kNodeSize; ++taken_, ++counters_.bytes_thrown_away) {
    const std::uint8_t* const at = waiting_.data() + taken_;
    const auto first = read_node(std::span<const std::uint8_t, kNodeSize>(at, kNodeSize));
    const auto second = read_node(std::span<const std::uint8_t, kNodeSize>(at + kNodeSize, kNodeSize));
    if (!first || !second || !follows(*first, *second)) continue;
    in_step_ = true;
    last_.reset();
    return true;
  }
  return false;
}

}  // namespace bw::laser
