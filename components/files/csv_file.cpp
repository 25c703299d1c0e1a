#include "components/files/csv_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "runtime/bounded_line.hpp"

namespace bw {
namespace {

constexpr std::size_t kLongestLine = 4096;

/// The first column in which two headers differ, as a sentence: tables may have hundreds of columns.
std::string first_difference(std::string_view expected, std::string_view found) {
  const auto name = [](std::string_view rest) { return rest.substr(0, rest.find(',')); };
  for (std::size_t column = 1;; ++column) {
    const std::size_t comma_expected = expected.find(',');
    const std::size_t comma_found = found.find(',');
    const bool ends_expected = comma_expected == std::string_view::npos;
    const bool ends_found = comma_found == std::string_view::npos;
    const std::string here = "column " + std::to_string(column) + " of the header ";
    if (name(expected) != name(found))
      return here + "must be " + excerpt(name(expected)) + ", found " + excerpt(name(found));
    if (ends_expected) return here + "must be the last, found more";
    if (ends_found) {
      expected.remove_prefix(comma_expected + 1);
      return here + "is the last, but " + excerpt(name(expected)) + " must follow";
    }
    expected.remove_prefix(comma_expected + 1);
    found.remove_prefix(comma_found + 1);
  }
}

}  // namespace

std::string excerpt(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + shown + (text.size() > 40 ? "...'" : "'");
}

void fail_at(const std::string& file, std::size_t line, const std::string& what) {
  throw std::runtime_error(file + ":" + std::to_string(line) + ": " + what);
}

double to_number(std::string_view text, const std::string& file, std::size_t line, CsvNumbers numbers) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (!is_number || std::isnan(value) || (std::isinf(value) && numbers == CsvNumbers::finite)) {
    const char* const rule = numbers == CsvNumbers::finite ? " is not a finite number" : " is not a number";
    fail_at(file, line, excerpt(text) + rule);
  }
  return value;
}

bool next_line(std::istream& input, std::string& text, const std::string& file, std::size_t line) {
  if (!read_line(input, text, kLongestLine)) return false;
  if (text.size() > kLongestLine)
    fail_at(file, line, "line longer than " + std::to_string(kLongestLine) + " characters");
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return true;
}

std::vector<CsvRow> read_csv(std::istream& input, const std::string& file, std::string_view header,
                             CsvNumbers numbers) {
  std::string text;
  if (!next_line(input, text, file, 1)) fail_at(file, 1, "the header is missing");
  if (text != header) fail_at(file, 1, first_difference(header, text));
  const auto columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1;
  std::vector<CsvRow> rows;
  for (std::size_t line = 2; next_line(input, text, file, line); ++line) {
    if (text.empty() && input.peek() == std::istream::traits_type::eof()) break;
    CsvRow row{line, {}};
    std::string_view rest = text;
    for (bool more = true; more;) {
      const std::size_t comma = rest.find(',');
      more = comma != std::string_view::npos;
      row.values.push_back(to_number(rest.substr(0, comma), file, line, numbers));
      if (more) rest.remove_prefix(comma + 1);
    }
    if (row.values.size() != columns) {
      fail_at(
          file, line,
          std::to_string(row.values.size()) + " values where the header names " + std::to_string(columns));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<CsvRow> read_csv(const std::string& file, std::string_view header, CsvNumbers numbers) {
  std::ifstream input(file);
  if (!input) throw std::runtime_error(file + ": cannot be opened");
  return read_csv(input, file, header, numbers);
}

}  // namespace bw
