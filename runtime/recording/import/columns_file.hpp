// What a columns file says: which column of which table is which field of which message. README.md has one in
// full.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/parameters/config_error.hpp"
#include "runtime/recording/import/table_reader.hpp"
#include "runtime/recording/import/units.hpp"

namespace bw::imports {

enum class Turning { counter_clockwise, clockwise };
constexpr auto choice_table(Turning) {
  using enum Turning;
  return choices<Turning>({{counter_clockwise, "counter_clockwise"}, {clockwise, "clockwise"}});
}

enum class AngleZero { x, north };  ///< x points east
constexpr auto choice_table(AngleZero) {
  using enum AngleZero;
  return choices<AngleZero>({{x, "x"}, {north, "north"}});
}

enum class AtStamp { refuse, drop, keep };
constexpr auto choice_table(AtStamp) {
  using enum AtStamp;
  return choices<AtStamp>({{refuse, "refuse"}, {drop, "drop"}, {keep, "keep"}});
}

/// A cell that is no measurement.
struct Gap {
  std::string text;             ///< as it is, or a number of equal value
  std::optional<double> value;  ///< what stands in the message; nothing: the row gives no such message
};

/// Where one field has its value from. One of column, columns, value and by_count is given.
struct ValueRule {
  Location where;
  std::string key;    ///< for complaints: tables.0.messages.1.fields.angle_min
  std::string field;  ///< path in the message
  std::optional<std::string> column;
  std::optional<std::string> columns;
  std::optional<std::string> value;
  std::vector<std::pair<std::size_t, double>> by_count;  ///< the value by the number of cells of column `of`
  std::string of;
  std::string unit_text;
  Unit unit;  ///< of what stands in the table; SI if it is not told
  Turning turning = Turning::counter_clockwise;
  AngleZero zero = AngleZero::x;
  bool sigma = false;    ///< a standard deviation of a field that is a variance
  bool reverse = false;  ///< the last cell of several comes first
  double min = -std::numeric_limits<double>::infinity();  ///< of the number in the table
  double max = std::numeric_limits<double>::infinity();
  double no_return_above =
      std::numeric_limits<double>::infinity();  ///< numbers in the table above this are +inf
  std::vector<Gap> gaps;
};

struct StampRule {
  Location where;
  std::string key;
  std::string column;
  std::string unit = "s";
  std::string nanoseconds;   ///< a second column that is added; empty: none
  std::string offset = "0";  ///< added [s]
  AtStamp on_duplicate = AtStamp::refuse;
  AtStamp on_falling = AtStamp::refuse;
};

/// One message for each row that it chooses.
struct MessageRule {
  Location where;
  std::string key;
  std::string topic;
  std::string type;
  std::string line;                  ///< first word of the rows; empty: all
  bool once = false;                 ///< of the first of these rows alone
  std::vector<std::string> columns;  ///< as in ColumnLayout::of_list(); empty: the table's
  Location columns_where;
  StampRule stamp;
  std::vector<ValueRule> values;
};

struct TableRule {
  Location where;
  std::string key;
  std::string file;  ///< name, with * and ? for any characters
  bool optional = false;
  bool other_lines = false;  ///< rows whose first word no message chooses are stepped over, not refused
  TableFormat format;
  std::vector<MessageRule> messages;
};

struct LogDescription {
  std::string name;
  std::string source;
  std::string licence;
  std::optional<double> start;  ///< stamp of the log's beginning [s]; nothing: the first one
  std::map<std::string, double>
      parameters;  ///< what the log declares of the robot: wheel_separation [m] and the like
};

struct ColumnsFile {
  std::filesystem::path path;
  LogDescription log;
  std::vector<TableRule> tables;
};

/// Throws ConfigError with everything that is wrong in the file itself; what only the tables can tell is
/// refused by the import.
ColumnsFile read_columns_file(const std::filesystem::path& file);

}  // namespace bw::imports
