#include "components/people/files/person_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>

#include "components/files/csv_file.hpp"

namespace bw::people {
namespace {

enum Column : std::size_t { kTime, kStamp, kId, kX, kY, kFrame, kVisible, kColumns };
constexpr std::array<std::string_view, kColumns> kNames{"time", "stamp", "id", "x", "y", "frame", "visible"};

std::vector<std::string_view> cells_of(std::string_view text) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = text.find(',');
    cells.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    text.remove_prefix(comma + 1);
  }
}

class Reader {
 public:
  Reader(std::istream& input, const std::string& file) : input_(input) { labels_.file = file; }

  PersonLabels read() {
    std::string text;
    if (!next_line(input_, text, labels_.file, line_)) fail("the header is missing");
    read_header(text);
    for (++line_; next_line(input_, text, labels_.file, line_); ++line_) {
      if (text.empty() && input_.peek() == std::istream::traits_type::eof()) break;
      read_row(cells_of(text));
    }
    if (labels_.rows.empty()) fail("nobody is labelled");
    return std::move(labels_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_at(labels_.file, line_, what); }
  [[noreturn]] void fail(Column column, const std::string& what) const {
    fail("column " + std::string(kNames[column]) + ": " + what);
  }

  void read_header(std::string_view text) {
    const std::vector<std::string_view> names = cells_of(text);
    index_.fill(-1);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto known = std::ranges::find(kNames, names[i]);
      const std::string here = "column " + std::to_string(i + 1) + ", " + excerpt(names[i]) + ", ";
      if (known == kNames.end())
        fail(here + "is unknown: columns are time or stamp, id, x, y, frame, visible");
      int& index = index_[static_cast<std::size_t>(known - kNames.begin())];
      if (index >= 0) fail(here + "is there twice");
      index = static_cast<int>(i);
    }
    for (const Column needed : {kId, kX, kY, kFrame}) {
      if (index_[needed] < 0) fail("column '" + std::string(kNames[needed]) + "' is missing");
    }
    if ((index_[kTime] < 0) == (index_[kStamp] < 0))
      fail("one of the columns 'time' (since the first scan) and 'stamp' must be there, and not both");
    labels_.has_stamps = index_[kStamp] >= 0;
    columns_ = names.size();
  }

  void read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != columns_) {
      fail(std::to_string(cells.size()) + " values where the header names " + std::to_string(columns_));
    }
    const auto text = [&](Column column) { return cells[static_cast<std::size_t>(index_[column])]; };
    PersonLabel label;
    label.line = line_;
    label.time = number(labels_.has_stamps ? kStamp : kTime, cells);
    label.id = static_cast<std::uint32_t>(whole(kId, cells, 1, std::numeric_limits<std::uint32_t>::max()));
    label.position = {number(kX, cells), number(kY, cells)};
    label.frame = text(kFrame);
    if (label.frame.empty()) fail(kFrame, "names no frame");
    if (index_[kVisible] >= 0) label.is_visible = whole(kVisible, cells, 0, 1) != 0.0;
    keep(std::move(label));
  }

  void keep(PersonLabel label) {
    const Column column = labels_.has_stamps ? kStamp : kTime;
    if (!labels_.rows.empty() && label.time < labels_.rows.back().time)
      fail(column,
           "is before that of line " + std::to_string(labels_.rows.back().line) + ": times must not fall");
    if (labels_.rows.empty() || label.time > labels_.rows.back().time) at_this_time_.clear();
    if (!at_this_time_.insert(label.id).second)
      fail(kId, std::to_string(label.id) + " is labelled twice at this time");
    labels_.rows.push_back(std::move(label));
  }

  double number(Column column, const std::vector<std::string_view>& cells) const {
    const std::string_view cell = cells[static_cast<std::size_t>(index_[column])];
    try {
      return to_number(cell, labels_.file, line_);
    } catch (const std::runtime_error&) {
      fail(column, excerpt(cell) + " is not a finite number");
    }
  }

  double whole(Column column, const std::vector<std::string_view>& cells, double least, double most) const {
    const double value = number(column, cells);
    if (value != std::floor(value) || value < least || value > most) {
      fail(column, excerpt(cells[static_cast<std::size_t>(index_[column])]) +
                       " must be a whole number from " + std::to_string(static_cast<std::uint64_t>(least)) +
                       " to " + std::to_string(static_cast<std::uint64_t>(most)));
    }
    return value;
  }

  std::istream& input_;
  PersonLabels labels_;
  std::size_t line_ = 1;
  std::array<int, kColumns> index_{};  ///< of each column in a row; -1: it is not there
  std::size_t columns_ = 0;
  std::set<std::uint32_t> at_this_time_;
};

}  // namespace

PersonLabels read_person_labels(std::istream& input, const std::string& file) {
  return Reader(input, file).read();
}

PersonLabels read_person_labels(const std::string& file) {
  std::ifstream input(file);
  if (!input) throw std::runtime_error(file + ": cannot be opened");
  return read_person_labels(input, file);
}

}  // namespace bw::people
