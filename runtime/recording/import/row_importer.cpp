#include "runtime/recording/import/row_importer.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include "runtime/recording/import/scan_header.hpp"
#include "runtime/recording/import/stamp_text.hpp"

namespace bw::imports {
namespace {

constexpr Time kLast{std::int64_t{std::numeric_limits<std::int32_t>::max()} * 1'000'000'000};

}  // namespace

RowImporter::RowImporter(const MessageRule& rule, const TypeDescription& type, ColumnLayout columns,
                         std::string table)
    : rule_(rule), columns_(std::move(columns)), table_(std::move(table)), draft_(type) {
  stamp_column_ = stamp_column(rule.stamp.column, "column");
  if (!rule.stamp.nanoseconds.empty())
    nanoseconds_column_ = stamp_column(rule.stamp.nanoseconds, "nanoseconds");
  offset_ = stamp_of_text(rule.stamp.offset, "s").value();
  for (const ValueRule& value : rule.values) writers_.emplace_back(value, draft_, columns_, table_);
  completes_scans_ = type.ros_name == "sensor_msgs/msg/LaserScan";
}

std::size_t RowImporter::stamp_column(const std::string& text, const char* key) const {
  try {
    const std::size_t column = columns_.column(text);
    if (columns_.is_several(column)) throw std::invalid_argument("several cells, where the stamp is one");
    return column;
  } catch (const std::invalid_argument& error) {
    throw ConfigError(Violation{rule_.stamp.where, rule_.stamp.key + "." + key, text,
                                std::string(error.what()) + ", in " + table_});
  }
}

Time RowImporter::stamp_of(const Row& row) const {
  const auto read = [&](std::size_t column, const std::string& unit) {
    const std::size_t cell = columns_.cells(column).first;
    const auto stamp = stamp_of_text(row.cells[cell], unit);
    if (!stamp)
      throw TableError(table_, row.line, cell + 1, columns_.name(column), row.cells[cell],
                       "is no stamp in " + unit);
    return *stamp;
  };
  Duration sum = read(stamp_column_, rule_.stamp.unit) + offset_;
  if (nanoseconds_column_) sum = sum + read(*nanoseconds_column_, "ns");
  const Time stamp{sum.nanoseconds};
  if (stamp < Time{} || stamp > kLast) {
    const std::size_t cell = columns_.cells(stamp_column_).first;
    throw TableError(table_, row.line, cell + 1, columns_.name(stamp_column_), row.cells[cell],
                     "a stamp must lie in 0 ... 2147483647 s, with its offset");
  }
  return stamp;
}

bool RowImporter::is_wanted(const Row& row, Time stamp) {
  if (!last_ || stamp > *last_) {
    last_ = stamp;
    return true;
  }
  const bool is_duplicate = stamp == *last_;
  const AtStamp what = is_duplicate ? rule_.stamp.on_duplicate : rule_.stamp.on_falling;
  if (what == AtStamp::refuse) {
    const std::size_t cell = columns_.cells(stamp_column_).first;
    throw TableError(table_, row.line, cell + 1, columns_.name(stamp_column_), row.cells[cell],
                     is_duplicate ? "is the stamp of the row before; on_duplicate may be drop or keep"
                                  : "is before the stamp of a row above; on_falling may be drop or keep");
  }
  ++(is_duplicate ? counts_.duplicate_stamps : counts_.falling_stamps);
  return what == AtStamp::keep;
}

std::optional<Time> RowImporter::read(const Row& row) {
  columns_.lay_over(row, table_);
  ++counts_.rows;
  const Time stamp = stamp_of(row);
  if (!is_wanted(row, stamp)) return std::nullopt;
  for (FieldWriter& writer : writers_) {
    if (writer.write(row, columns_, table_, draft_)) continue;
    ++counts_.skipped;
    return std::nullopt;
  }
  draft_.set_stamps(stamp);
  if (completes_scans_) complete_scan(rule_.values, draft_);
  ++counts_.messages;
  return stamp;
}

}  // namespace bw::imports
