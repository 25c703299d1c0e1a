#include "runtime/recording/import/column_layout.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw::imports {
namespace {

constexpr std::size_t kMaxCells = 1'000'000;

/// A whole number from 0 to kMaxCells.
std::optional<std::size_t> count_of(std::string_view text) {
  const std::optional<std::int64_t> number = parse_integer(text);
  if (!number || *number < 0 || *number > static_cast<std::int64_t>(kMaxCells)) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

}  // namespace

ColumnLayout ColumnLayout::of_header(const std::vector<std::string>& names) {
  ColumnLayout layout;
  for (const std::string& name : names) {
    const bool twice = !name.empty() &&
                       std::ranges::any_of(layout.columns_, [&](const Column& c) { return c.name == name; });
    if (twice) throw std::invalid_argument("two columns are named '" + name + "'");
    layout.columns_.push_back({.name = name});
  }
  return layout;
}

ColumnLayout ColumnLayout::of_list(const std::vector<std::string>& entries) {
  ColumnLayout layout;
  for (const std::string& entry : entries) {
    if (layout.open_end_) throw std::invalid_argument("'...' must be the last");
    if (entry == "...") {
      layout.open_end_ = true;
    } else {
      layout.add(entry);
    }
  }
  const auto rests = std::ranges::count(layout.columns_, Kind::rest, &Column::kind);
  if (rests > 1 || (rests == 1 && layout.open_end_))
    throw std::invalid_argument("only one column can be all that the others leave");
  const auto rest = std::ranges::find(layout.columns_, Kind::rest, &Column::kind);
  if (std::find_if(rest, layout.columns_.end(), [](const Column& c) { return c.kind == Kind::counted; }) !=
      layout.columns_.end())
    throw std::invalid_argument("behind a column that is all that the others leave nothing can be counted");
  return layout;
}

ColumnLayout ColumnLayout::of_width(std::size_t cells) {
  ColumnLayout layout;
  layout.columns_.resize(cells);
  return layout;
}

void ColumnLayout::add(const std::string& entry) {
  Column column{.name = entry};
  if (const std::size_t bracket = entry.find('['); bracket != std::string::npos && entry.back() == ']') {
    column.name = entry.substr(0, bracket);
    const std::string count = entry.substr(bracket + 1, entry.size() - bracket - 2);
    if (count == "*") {
      column.kind = Kind::rest;
    } else if (const auto number = count_of(count)) {
      column.kind = Kind::fixed;
      column.count = *number;
    } else {
      const auto by = std::ranges::find(columns_, count, &Column::name);
      if (by == columns_.end() || by->kind != Kind::one)
        throw std::invalid_argument("'" + count +
                                    "' is no number, and no column of one cell before this one");
      column.kind = Kind::counted;
      column.counted_by = static_cast<std::size_t>(by - columns_.begin());
    }
  }
  if (column.name.empty()) throw std::invalid_argument("a column needs a name");
  if (std::ranges::find(columns_, column.name, &Column::name) != columns_.end())
    throw std::invalid_argument("two columns are named '" + column.name + "'");
  columns_.push_back(std::move(column));
}

std::size_t ColumnLayout::column(std::string_view text) const {
  const auto named = std::ranges::find(columns_, text, &Column::name);
  if (!text.empty() && named != columns_.end()) return static_cast<std::size_t>(named - columns_.begin());
  if (const auto number = count_of(text)) {
    if (*number >= 1 && *number <= columns_.size()) return *number - 1;
    throw std::invalid_argument(fmt::format("there are columns 1 to {}", columns_.size()));
  }
  std::vector<std::string_view> known;
  for (const Column& c : columns_) {
    if (!c.name.empty()) known.push_back(c.name);
  }
  if (known.empty()) throw std::invalid_argument("the columns have no names, only numbers from 1");
  constexpr std::size_t kMaxNames = 30;
  const auto near = nearest_of(text, known);
  if (!near && known.size() > kMaxNames) throw std::invalid_argument("unknown column");
  throw std::invalid_argument(unknown_rule("column", text, known));
}

std::pair<std::size_t, std::size_t> ColumnLayout::columns(std::string_view text) const {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) {
    const std::size_t one = column(text);
    if (!is_several(one)) throw std::invalid_argument("is one cell; several are written as first..last");
    return {one, one};
  }
  const std::size_t first = column(text.substr(0, dots));
  const std::string_view end = text.substr(dots + 2);
  const std::size_t last = end.empty() ? columns_.size() - 1 : column(end);
  if (last < first) throw std::invalid_argument("the last column stands before the first");
  return {first, last};
}

std::size_t ColumnLayout::counted(const Column& column, const Row& row, const std::string& table) const {
  if (column.kind != Kind::counted) return column.kind == Kind::rest ? 0 : column.count;
  const std::size_t at = ranges_[column.counted_by].first;
  if (at >= row.cells.size()) return 0;  // the row is too short, which lay_over() says
  if (const auto count = count_of(row.cells[at])) return *count;
  throw TableError(table, row.line, at + 1, columns_[column.counted_by].name, row.cells[at],
                   fmt::format("must be a whole number, the count of '{}'", column.name));
}

void ColumnLayout::lay_over(const Row& row, const std::string& table) {
  ranges_.assign(columns_.size(), {});
  std::size_t needed = 0;
  std::size_t rest = columns_.size();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].kind == Kind::rest) rest = i;
    ranges_[i] = {needed, counted(columns_[i], row, table)};
    needed += ranges_[i].count;
  }
  const std::size_t found = row.cells.size();
  const bool has_rest = rest < columns_.size();
  const bool fits = has_rest || open_end_ ? found >= needed : found == needed;
  if (!fits) {
    throw TableError(table, row.line,
                     fmt::format("{} cells where {}{} are expected", found,
                                 has_rest || open_end_ ? "at least " : "", needed));
  }
  if (!has_rest) return;
  ranges_[rest].count = found - needed;
  for (std::size_t i = rest + 1; i < columns_.size(); ++i) ranges_[i].first += found - needed;
}

}  // namespace bw::imports
