// Obstacles by where they are: what is near a position is found without a look at the rest.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "components/model/footprint_distance.hpp"
#include "components/model/obstacles.hpp"

namespace bw {

/// Points, discs and segments as capsules, in this order.
std::vector<Capsule> capsules_of(const StaticObstacles& statics);

/// Cells that have a number, by column and row. Finding one takes a time that does not depend on how many
/// there are.
class CellNumbers {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// The number of the cell, the next one if it has none yet.
  std::uint32_t number(std::int32_t column, std::int32_t row);
  /// kNone if it has none.
  std::uint32_t find(std::int32_t column, std::int32_t row) const;
  std::size_t size() const { return count_; }

 private:
  struct Slot {
    std::int32_t column = 0, row = 0;
    std::uint32_t number = kNone;
  };
  std::size_t slot_of(std::int32_t column, std::int32_t row) const;
  void grow();

  std::vector<Slot> slots_;  ///< a power of two of them, at least half of them free
  int shift_ = 63;
  std::uint32_t count_ = 0;
};

/// Built once, in a time linear in the number of capsules, and read by any number of threads. Capsules are
/// finite.
class CapsuleIndex {
 public:
  /// Capsules that lie within a few centimetres of each other, or a piece of a long one.
  struct Group {
    Vector2 low{0.0, 0.0}, high{0.0, 0.0};  ///< box around their axes (that of the piece)
    double radius = 0.0;                    ///< of the widest
    std::uint32_t first = 0, last = 0;      ///< [first, last) of the order of members

    double squared_distance(const Vector2& point) const {
      const double x = std::max({low.x() - point.x(), 0.0, point.x() - high.x()});
      const double y = std::max({low.y() - point.y(), 0.0, point.y() - high.y()});
      return x * x + y * y;
    }
  };

  CapsuleIndex() = default;
  explicit CapsuleIndex(std::vector<Capsule> capsules);

  const std::vector<Capsule>& capsules() const { return capsules_; }
  std::size_t size() const { return capsules_.size(); }
  /// Indices into capsules().
  std::span<const std::uint32_t> members(const Group& group) const {
    return {members_.data() + group.first, members_.data() + group.last};
  }
  /// visit(group) for every group whose box comes so near to `centre` that a capsule of it may be within
  /// `reach` [m]: of all capsules within reach none is missed. A long capsule may come several times, in at
  /// most 200 pieces.
  template <class Visit>
  void visit_near(const Vector2& centre, double reach, Visit&& visit) const;

 private:
  static constexpr double kCell = 1.0;  // [m] side of the cells that groups are looked for in

  static std::int32_t cell(double coordinate, double side) {
    const double scaled = std::clamp(coordinate * (1.0 / side), -2e9, 2e9);
    const auto whole = static_cast<std::int32_t>(scaled);
    return static_cast<double>(whole) > scaled ? whole - 1 : whole;
  }
  void form_groups();
  void file_groups();

  std::vector<Capsule> capsules_;
  std::vector<std::uint32_t> members_;
  std::vector<Group> groups_;
  // Groups by the cell of the middle of their box; none of this where there are few.
  CellNumbers cells_;
  std::vector<std::uint32_t> cell_begin_;
  std::vector<std::uint32_t> filed_;
  std::vector<std::uint32_t> wide_;  // those that reach so far that they are not filed
  double extent_ = 0.0;              // [m] largest half side of a box, and radius, of the filed ones
};

template <class Visit>
void CapsuleIndex::visit_near(const Vector2& centre, double reach, Visit&& visit) const {
  const auto look_at = [&](const Group& group) {
    const double limit = reach + group.radius;
    if (group.squared_distance(centre) <= limit * limit) visit(group);
  };
  const double aside = reach + extent_;
  const double columns = 2.0 * aside / kCell + 2.0;
  if (cells_.size() == 0 || columns * columns > static_cast<double>(groups_.size())) {
    for (const Group& group : groups_) look_at(group);
    return;
  }
  for (const std::uint32_t g : wide_) look_at(groups_[g]);
  for (std::int32_t row = cell(centre.y() - aside, kCell); row <= cell(centre.y() + aside, kCell); ++row) {
    for (std::int32_t column = cell(centre.x() - aside, kCell); column <= cell(centre.x() + aside, kCell);
         ++column) {
      const std::uint32_t number = cells_.find(column, row);
      if (number == CellNumbers::kNone) continue;
      for (std::uint32_t i = cell_begin_[number]; i < cell_begin_[number + 1]; ++i) {
        look_at(groups_[filed_[i]]);
      }
    }
  }
}

}  // namespace bw
