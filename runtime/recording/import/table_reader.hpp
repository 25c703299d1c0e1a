// A text table, row by row: comma, semicolon, tab or white space between the cells.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/choice.hpp"

namespace bw::imports {

enum class Separator { comma, semicolon, tab, whitespace };
constexpr auto choice_table(Separator) {
  using enum Separator;
  return choices<Separator>(
      {{comma, "comma"}, {semicolon, "semicolon"}, {tab, "tab"}, {whitespace, "whitespace"}});
}

struct TableFormat {
  Separator separator = Separator::comma;
  bool header = false;  ///< the first row names the columns
  std::string comment;  ///< lines that begin so are none; empty: there are no such lines
};

struct Row {
  std::size_t line = 0;  ///< in the file, from 1
  std::vector<std::string> cells;
};

/// What is wrong in a table: "imu.csv:3: column 4 (yaw) = 'x': is no number". Nothing of the import is kept
/// then.
class TableError : public std::runtime_error {
 public:
  /// `column`: from 1; 0: the line as a whole.
  TableError(const std::string& table, std::size_t line, std::size_t column, std::string_view name,
             std::string_view cell, std::string_view rule);
  TableError(const std::string& table, std::size_t line, std::string_view rule);
};

/// Blank lines and comments are stepped over; a byte order mark and Windows line ends are no part of a cell.
/// Cells of a separated table may stand in double quotes, and lose blanks around them.
class TableReader {
 public:
  /// The file may be compressed by gzip (text_input.hpp). Throws std::runtime_error naming it when it cannot
  /// be read, TableError when the header is missing.
  TableReader(const std::filesystem::path& file, const TableFormat& format);

  /// False at the end. Throws TableError for a line longer than a mebibyte and a quote that does not end.
  bool next(Row& row);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Row& header() const { return header_; }  ///< without cells if there is none

 private:
  void split(std::string_view text, Row& row) const;

  std::string name_;
  TableFormat format_;
  std::unique_ptr<std::istream> input_;
  std::string text_;
  std::size_t line_ = 0;
  Row header_;
};

}  // namespace bw::imports
