#include "components/people/tracker/assignment.hpp"

#include <limits>

namespace bw::people {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void Assignment::begin(std::size_t columns) {
  pairs_.clear();
  rows_.clear();
  column_of_.clear();
  row_of_.assign(columns, -1);
  potential_.assign(columns, 0.0);
  distance_.assign(columns, kFar);
  from_.assign(columns, -1);
  finished_.assign(columns, 0);
}

void Assignment::add_row(double alone) {
  rows_.push_back({pairs_.size(), pairs_.size(), alone});
  column_of_.push_back(kAlone);
}

void Assignment::allow(std::size_t column, double cost) {
  pairs_.push_back({static_cast<int>(column), cost});
  rows_.back().end = pairs_.size();
}

/// Offers the columns of `row`, which was reached at `distance`, and the way of leaving it alone.
void Assignment::reach(int row, double distance) {
  const Row& r = rows_[index(row)];
  const int column = column_of_[index(row)];
  // A row that holds a column gives it back: what it costs there no longer counts.
  const double given_back = column == kAlone ? 0.0 : r.cost - potential_[index(column)];
  const double alone = distance + r.alone - given_back;
  if (alone < give_up_distance_) {
    give_up_distance_ = alone;
    give_up_row_ = row;
  }
  for (std::size_t k = r.first; k < r.end; ++k) {
    const std::size_t j = index(pairs_[k].column);
    if (finished_[j] != 0) continue;
    const double candidate = distance + pairs_[k].cost - potential_[j] - given_back;
    if (candidate >= distance_[j]) continue;
    if (distance_[j] == kFar) touched_.push_back(pairs_[k].column);
    distance_[j] = candidate;
    from_[j] = row;
  }
}

/// Gives the free `column` to the row before it on the path, that row's old column to the one before, and so
/// on.
void Assignment::hand_over(int column, int start) {
  for (;;) {
    const int row = from_[index(column)];
    const int old = column_of_[index(row)];
    column_of_[index(row)] = column;
    row_of_[index(column)] = row;
    Row& r = rows_[index(row)];
    for (std::size_t k = r.first; k < r.end; ++k)
      if (pairs_[k].column == column) r.cost = pairs_[k].cost;
    if (row == start) return;
    column = old;
  }
}

void Assignment::place(int start) {
  touched_.clear();
  give_up_distance_ = kFar;
  give_up_row_ = -1;
  reach(start, 0.0);
  int free_column = -1;
  double end = kFar;
  for (;;) {
    int nearest = -1;
    end = give_up_distance_;
    for (const int j : touched_) {
      if (finished_[index(j)] != 0 || distance_[index(j)] >= end) continue;
      end = distance_[index(j)];
      nearest = j;
    }
    if (nearest < 0) break;
    if (row_of_[index(nearest)] < 0) {
      free_column = nearest;
      break;
    }
    finished_[index(nearest)] = 1;
    reach(row_of_[index(nearest)], end);
  }
  for (const int j : touched_) {
    if (finished_[index(j)] != 0) potential_[index(j)] += distance_[index(j)] - end;
  }
  if (free_column >= 0) {
    hand_over(free_column, start);
  } else if (give_up_row_ != start) {
    const int column = column_of_[index(give_up_row_)];
    column_of_[index(give_up_row_)] = kAlone;
    hand_over(column, start);
  }
  for (const int j : touched_) {
    distance_[index(j)] = kFar;
    finished_[index(j)] = 0;
  }
}

const std::vector<int>& Assignment::solve() {
  for (std::size_t row = 0; row < rows_.size(); ++row) place(static_cast<int>(row));
  return column_of_;
}

double Assignment::total() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    sum += column_of_[i] == kAlone ? rows_[i].alone : rows_[i].cost;
  return sum;
}

}  // namespace bw::people
