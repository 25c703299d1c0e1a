// The messages that one entry of a columns file makes of the rows of one table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/recording/import/columns_file.hpp"
#include "runtime/recording/import/field_writer.hpp"

namespace bw::imports {

/// What became of the rows; printed, so that nothing is lost in silence.
struct RowCounts {
  std::uint64_t rows = 0;
  std::uint64_t messages = 0;
  std::uint64_t skipped = 0;  ///< by a gap
  std::uint64_t duplicate_stamps = 0;
  std::uint64_t falling_stamps = 0;
};

class RowImporter {
 public:
  /// `rule` must outlive this. `columns`: of the header; without names and list, of the first row's width.
  /// Throws ConfigError.
  RowImporter(const MessageRule& rule, const TypeDescription& type, ColumnLayout columns, std::string table);

  /// The stamp of the message that the row gives, if it gives one: write() then writes it. Throws TableError.
  std::optional<Time> read(const Row& row);
  void write(std::vector<std::uint8_t>& cdr) const { draft_.write(cdr); }

  [[nodiscard]] const MessageRule& rule() const { return rule_; }
  [[nodiscard]] const RowCounts& counts() const { return counts_; }

 private:
  [[nodiscard]] std::size_t stamp_column(const std::string& text, const char* key) const;
  [[nodiscard]] Time stamp_of(const Row& row) const;
  [[nodiscard]] bool is_wanted(const Row& row, Time stamp);

  const MessageRule& rule_;
  ColumnLayout columns_;
  std::string table_;
  MessageDraft draft_;
  std::vector<FieldWriter> writers_;
  std::size_t stamp_column_ = 0;
  std::optional<std::size_t> nanoseconds_column_;
  Duration offset_;
  bool completes_scans_ = false;
  std::optional<Time> last_;
  RowCounts counts_;
};

}  // namespace bw::imports
