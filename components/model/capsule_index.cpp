#include "components/model/capsule_index.hpp"

#include <bit>
#include <utility>

namespace bw {
namespace {

constexpr double kGroupSide =
    0.035;                      // [m] of the cell whose capsules are one group: 5 cm from corner to corner
constexpr double kShort = 0.1;  // [m] axes up to this length are grouped by their middle
constexpr double kPiece = 1.0;  // [m] of longer ones
constexpr double kMaxPieces = 200.0;  // of one; those of a still longer one are longer
constexpr double kWide = 2.0;  // [m] half side and radius from which on a group is looked at from everywhere
constexpr std::size_t kFewestSlots = 64;
constexpr std::size_t kFewGroups = 32;  // that are looked at one by one

}  // namespace

std::vector<Capsule> capsules_of(const StaticObstacles& statics) {
  std::vector<Capsule> capsules;
  capsules.reserve(statics.size());
  for (const Vector2& p : statics.points) capsules.push_back({p, p, 0.0});
  for (const Disc& d : statics.discs) capsules.push_back({d.center, d.center, d.radius});
  for (const Segment& s : statics.segments) capsules.push_back({s.a, s.b, 0.0});
  return capsules;
}

void CellNumbers::grow() {
  std::vector<Slot> before =
      std::exchange(slots_, std::vector<Slot>(std::max(2 * slots_.size(), kFewestSlots)));
  shift_ = 64 - std::countr_zero(slots_.size());
  for (const Slot& slot : before) {
    if (slot.number != kNone) slots_[slot_of(slot.column, slot.row)] = slot;
  }
}

std::size_t CellNumbers::slot_of(std::int32_t column, std::int32_t row) const {
  const std::uint64_t key =
      std::uint64_t{static_cast<std::uint32_t>(column)} << 32 | static_cast<std::uint32_t>(row);
  std::size_t slot = (key * 0x9E3779B97F4A7C15u) >> shift_;  // multiples of the golden ratio spread evenly
  while (slots_[slot].number != kNone && (slots_[slot].column != column || slots_[slot].row != row)) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slot;
}

std::uint32_t CellNumbers::number(std::int32_t column, std::int32_t row) {
  if (2 * count_ >= slots_.size()) grow();
  Slot& slot = slots_[slot_of(column, row)];
  if (slot.number == kNone) slot = {column, row, count_++};
  return slot.number;
}

std::uint32_t CellNumbers::find(std::int32_t column, std::int32_t row) const {
  return slots_.empty() ? kNone : slots_[slot_of(column, row)].number;
}

CapsuleIndex::CapsuleIndex(std::vector<Capsule> capsules) : capsules_(std::move(capsules)) {
  form_groups();
  if (groups_.size() > kFewGroups) file_groups();
}

void CapsuleIndex::form_groups() {
  CellNumbers numbers;
  std::vector<std::uint32_t> group_of(capsules_.size(), CellNumbers::kNone);
  const auto enclose = [](Group& group, const Vector2& a, const Vector2& b) {
    group.low = group.low.cwiseMin(a).cwiseMin(b);
    group.high = group.high.cwiseMax(a).cwiseMax(b);
  };
  groups_.reserve(capsules_.size());
  for (std::size_t i = 0; i < capsules_.size(); ++i) {
    const Capsule& c = capsules_[i];
    if ((c.b - c.a).squaredNorm() > kShort * kShort) continue;
    const Vector2 middle = 0.5 * (c.a + c.b);
    const std::uint32_t group = numbers.number(cell(middle.x(), kGroupSide), cell(middle.y(), kGroupSide));
    if (group == groups_.size()) groups_.push_back({c.a, c.a, 0.0, 0, 0});
    group_of[i] = group;
    enclose(groups_[group], c.a, c.b);
    groups_[group].radius = std::max(groups_[group].radius, c.radius);
    ++groups_[group].last;
  }
  std::uint32_t begin = 0;
  for (Group& group : groups_) {
    group.first = std::exchange(begin, begin + group.last);
    group.last = group.first;  // rises to where it belongs as the members come in
  }
  members_.resize(begin);
  for (std::size_t i = 0; i < capsules_.size(); ++i) {
    if (group_of[i] != CellNumbers::kNone)
      members_[groups_[group_of[i]].last++] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < capsules_.size(); ++i) {
    if (group_of[i] != CellNumbers::kNone) continue;
    const Capsule& c = capsules_[i];
    const Vector2 axis = c.b - c.a;
    const double pieces = std::min(std::ceil(axis.norm() / kPiece), kMaxPieces);
    members_.push_back(static_cast<std::uint32_t>(i));
    const auto last = static_cast<std::uint32_t>(members_.size());
    for (double k = 0.0; k < pieces; k += 1.0) {
      const Vector2 from = c.a + axis * (k / pieces);
      groups_.push_back({from, from, c.radius, last - 1, last});
      enclose(groups_.back(), from, k + 1.0 < pieces ? Vector2(c.a + axis * ((k + 1.0) / pieces)) : c.b);
    }
  }
}

void CapsuleIndex::file_groups() {
  std::vector<std::uint32_t> cell_of, filed;
  cell_of.reserve(groups_.size());
  filed.reserve(groups_.size());
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const double extent = group.radius + 0.5 * (group.high - group.low).maxCoeff();
    if (extent > kWide) {
      wide_.push_back(g);
      continue;
    }
    const Vector2 middle = 0.5 * (group.low + group.high);
    cell_of.push_back(cells_.number(cell(middle.x(), kCell), cell(middle.y(), kCell)));
    filed.push_back(g);
    extent_ = std::max(extent_, extent);
  }
  cell_begin_.assign(cells_.size() + 1, 0);
  for (const std::uint32_t c : cell_of) ++cell_begin_[c + 1];
  for (std::size_t c = 1; c < cell_begin_.size(); ++c) cell_begin_[c] += cell_begin_[c - 1];
  std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
  filed_.resize(filed.size());
  for (std::size_t i = 0; i < filed.size(); ++i) filed_[next[cell_of[i]]++] = filed[i];
}

}  // namespace bw
