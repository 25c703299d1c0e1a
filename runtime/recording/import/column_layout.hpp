// Which cells of a row belong to which column. A column may be several cells: as many as another column says,
// or all that the others leave.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/recording/import/table_reader.hpp"

namespace bw::imports {

/// Neighbouring cells of a row.
struct CellRange {
  std::size_t first = 0;  ///< from 0
  std::size_t count = 1;
};

class ColumnLayout {
 public:
  /// The columns of a header, or of a list as a columns file has it: `word`, `n`, `ranges[n]` (column n says
  /// how many cells), `ranges[1081]`, `ranges[*]` (all that the others leave), and at the end `...` (whatever
  /// else there is).
  /// Throws std::invalid_argument with the rule that the list breaks.
  static ColumnLayout of_header(const std::vector<std::string>& names);
  static ColumnLayout of_list(const std::vector<std::string>& entries);
  /// Columns without names.
  static ColumnLayout of_width(std::size_t cells);

  /// By name, or by number from 1. Throws std::invalid_argument with the rule that the text breaks.
  [[nodiscard]] std::size_t column(std::string_view text) const;
  /// A column of several cells by its name; or neighbours, `r0..r511` or `2..` (to the last). First and last
  /// column.
  [[nodiscard]] std::pair<std::size_t, std::size_t> columns(std::string_view text) const;
  [[nodiscard]] const std::string& name(std::size_t column) const { return columns_[column].name; }
  [[nodiscard]] bool is_several(std::size_t column) const { return columns_[column].kind != Kind::one; }

  /// Lays the columns over the cells of a row of `table`. Throws TableError when they do not fit.
  void lay_over(const Row& row, const std::string& table);
  /// Of the row laid over last.
  [[nodiscard]] CellRange cells(std::size_t column) const { return ranges_[column]; }

 private:
  enum class Kind { one, fixed, counted, rest };
  struct Column {
    std::string name;
    Kind kind = Kind::one;
    std::size_t count = 1;       ///< fixed
    std::size_t counted_by = 0;  ///< column
  };

  void add(const std::string& entry);
  [[nodiscard]] std::size_t counted(const Column& column, const Row& row, const std::string& table) const;

  std::vector<Column> columns_;
  bool open_end_ = false;
  std::vector<CellRange> ranges_;
};

}  // namespace bw::imports
