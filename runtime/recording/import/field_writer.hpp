// One field of a message, from the cells of each row.
#pragma once

#include <string>
#include <vector>

#include "runtime/recording/import/column_layout.hpp"
#include "runtime/recording/import/columns_file.hpp"
#include "runtime/recording/import/message_draft.hpp"

namespace bw::imports {

class FieldWriter {
 public:
  /// A constant is written at once. Throws ConfigError naming file, line and key of the rule for a field that
  /// the type does not have, a column that the table does not have, and a unit that is none of the field's.
  FieldWriter(const ValueRule& rule, MessageDraft& draft, const ColumnLayout& layout,
              const std::string& table);

  /// From a row that `layout` was laid over. False: a gap says that the row gives no such message. Throws
  /// TableError.
  bool write(const Row& row, const ColumnLayout& layout, const std::string& table, MessageDraft& draft);

  [[nodiscard]] const ValueRule& rule() const { return rule_; }

 private:
  struct Number {
    bool skips = false;
    double value = 0.0;
  };

  void bind_columns(const ColumnLayout& layout, const std::string& table);
  void check_unit() const;
  void write_constant(MessageDraft& draft) const;
  [[nodiscard]] Number number_of(const std::string& cell) const;
  [[nodiscard]] double to_si(double raw) const;
  [[nodiscard]] double by_count(const Row& row, const ColumnLayout& layout, const std::string& table) const;
  [[noreturn]] void refuse(const std::string& value, const std::string& why) const;

  ValueRule rule_;
  MessageDraft::Target target_;
  std::size_t first_ = 0;  ///< column
  std::size_t last_ = 0;
  std::vector<double> values_;
};

}  // namespace bw::imports
