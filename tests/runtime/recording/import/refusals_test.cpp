// Every mistake in a columns file or a table is refused, and its file, line and column are named.
#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/import/imported_bag.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"
#include "tests/runtime/recording/import/tables.hpp"

namespace bw::imports {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

/// A columns file with these parts; line 9 is `field`.
struct Parts {
  std::string top = "log: {name: l}";
  std::string table = "header: true";
  std::string stamp = "{column: t}";
  std::string topic = "/odom";
  std::string type = "nav_msgs/msg/Odometry";
  std::string field = "pose.pose.position.x: x";
  std::string constant = "child_frame_id: base_link";
};

std::string columns(const Parts& p) {
  return fmt::format(
      "{}\ntables:\n  - file: a.csv\n    {}\n    stamp: {}\n    messages:\n      - topic: {}\n        type: {}\n"
      "        fields: {{{}}}\n        constants: {{{}}}\n",
      p.top, p.table, p.stamp, p.topic, p.type, p.field, p.constant);
}

class Refusals : public ::testing::Test {
 protected:
  void SetUp() override { tables_.write("a.csv", "t,x,yaw,r0,r1\n1,2,90,4,5\n2,3,91,4,5\n"); }
  std::string refusal(const Parts& parts) const { return tables_.refusal(columns(parts)); }
  std::string refusal_of(const std::string& table, const Parts& parts = {}) const {
    tables_.write("a.csv", table);
    return refusal(parts);
  }
  Tables tables_;
};

TEST_F(Refusals, TheFileThatTheyAreMadeFromIsImported) { EXPECT_EQ(refusal({}), ""); }

TEST_F(Refusals, AWrongColumn) {
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.x: width"}),
      AllOf(HasSubstr("columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.x = width:"),
            HasSubstr("unknown column"), HasSubstr("known: t, x, yaw, r0, r1, in "), HasSubstr("a.csv")));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: yae"}), HasSubstr("did you mean 'yaw'?"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: 6"}), HasSubstr("there are columns 1 to 5"));
  EXPECT_THAT(
      refusal({.stamp = "{column: time}"}),
      AllOf(HasSubstr("columns.yaml:5: tables.0.stamp.column = time: unknown column"), HasSubstr("a.csv")));
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.x: {columns: r0..r1}"}),
      HasSubstr("columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.x = r0..r1: several cells"));
  EXPECT_THAT(
      refusal({.type = "sensor_msgs/msg/LaserScan", .field = "ranges: r0", .constant = ""}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.ranges = r0: one cell, where the field is a list"));
  EXPECT_THAT(
      refusal({.type = "sensor_msgs/msg/LaserScan", .field = "ranges: {columns: r1..r0}", .constant = ""}),
      HasSubstr("the last column stands before the first"));
}

TEST_F(Refusals, AWrongUnit) {
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.x: {column: x, unit: metres}"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.x.unit = metres: unknown unit; known: m,"));
  EXPECT_THAT(
      refusal({.field = "pose.pose.orientation.yaw: {column: yaw, unit: mm}"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.orientation.yaw = mm: must be a unit of an angle"));
  EXPECT_THAT(refusal({.field = "child_frame_id: {column: x, unit: mm}", .constant = ""}),
              HasSubstr("a text has no unit"));
  EXPECT_THAT(refusal({.field = "header.stamp: {column: x, unit: mm}"}), HasSubstr("must be a unit of time"));
  EXPECT_THAT(refusal({.stamp = "{column: t, unit: m}"}),
              HasSubstr("columns.yaml:5: tables.0.stamp.unit = m: must be a unit of time"));
  EXPECT_THAT(
      refusal({.constant = "pose.pose.position.y: 3 apples"}),
      HasSubstr(
          "columns.yaml:10: tables.0.messages.0.constants.pose.pose.position.y = 3 apples: unknown unit"));
}

TEST_F(Refusals, AWrongAngleConvention) {
  EXPECT_THAT(
      refusal({.field = "pose.pose.orientation.yaw: {column: yaw, unit: deg, zero: south}"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.orientation.yaw.zero = south: must be one of"));
  EXPECT_THAT(refusal({.field = "pose.pose.orientation.yaw: {column: yaw, unit: deg, turning: right}"}),
              HasSubstr("fields.pose.pose.orientation.yaw.turning = right: must be one of"));
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.x: {column: x, unit: m, zero: north}"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.x.zero = north: is for angles"));
  EXPECT_THAT(refusal({.field = "twist.twist.angular.z: {column: yaw, unit: deg/s, zero: north}"}),
              HasSubstr("is for angles"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: {column: x, turning: clockwise}"}),
              HasSubstr("is for angles and turn rates"));
}

TEST_F(Refusals, AWrongFieldTypeOrTopic) {
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.q: x"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.q: geometry_msgs/msg/Point has no 'q'"));
  EXPECT_THAT(
      refusal({.type = "nav_msgs/msg/Odometri"}),
      HasSubstr(
          "columns.yaml:7: tables.0.messages.0.type = nav_msgs/msg/Odometri: unknown type; did you mean 'nav_msgs/msg/Odometry'?"));
  EXPECT_THAT(refusal({.topic = "odom"}),
              HasSubstr("tables.0.messages.0.topic = odom: must be the topic's full name"));
  EXPECT_THAT(refusal({.constant = "\"pose.covariance[36]\": 1"}), HasSubstr("'covariance' has 36 elements"));
  EXPECT_THAT(
      refusal({.constant = "pose.pose.position.y: high"}),
      HasSubstr(
          "columns.yaml:10: tables.0.messages.0.constants.pose.pose.position.y = high: must be a number"));
}

TEST_F(Refusals, UnknownAndMissingKeys) {
  EXPECT_THAT(refusal({.top = "logg: {name: l}"}),
              HasSubstr("columns.yaml:1: logg: unknown key; did you mean 'log'?"));
  EXPECT_THAT(refusal({.top = "log: {nam: l}"}),
              HasSubstr("columns.yaml:1: log.nam: unknown key; did you mean 'name'?"));
  EXPECT_THAT(refusal({.table = "heder: true"}), HasSubstr("columns.yaml:4: tables.0.heder: unknown key"));
  EXPECT_THAT(refusal({.table = "separator: blank"}),
              HasSubstr("columns.yaml:4: tables.0.separator = blank: must be one of"));
  EXPECT_THAT(refusal({.stamp = "{colum: t}"}),
              HasSubstr("columns.yaml:5: tables.0.stamp.colum: unknown key"));
  EXPECT_THAT(refusal({.stamp = "{column: t, on_falling: ignore}"}),
              HasSubstr("tables.0.stamp.on_falling = ignore: must be one of"));
  EXPECT_THAT(refusal({.stamp = "{column: t, offset: x}"}),
              HasSubstr("tables.0.stamp.offset = x: must be a number of seconds"));
  EXPECT_THAT(refusal({.stamp = "{unit: s}"}), HasSubstr("column must name the column of the stamp"));
  EXPECT_THAT(
      refusal({.field = "pose.pose.position.x: {column: x, units: mm}"}),
      HasSubstr(
          "columns.yaml:9: tables.0.messages.0.fields.pose.pose.position.x.units: unknown key; did you mean 'unit'?"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: {unit: mm}"}),
              HasSubstr("one of column, columns and by_count must be given"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: {column: x, gaps: {'-': none}}"}),
              HasSubstr("gaps.- = none: must be nan, inf, -inf, a number (SI), or skip"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: [x]"}), HasSubstr("must be a column, or a section"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: {column: x, reverse: true}"}),
              HasSubstr("is for several columns"));
  EXPECT_THAT(refusal({.field = "pose.pose.position.x: {by_count: {2: 1}}"}),
              HasSubstr("by_count needs the column"));
  EXPECT_THAT(refusal({.table = "header: true\n    columns: [t, x]"}),
              HasSubstr("the header names the columns already"));
  EXPECT_THAT(refusal({.table = "columns: [t, t]"}), HasSubstr("two columns are named 't'"));
  EXPECT_THAT(tables_.refusal("tables: []"), HasSubstr("tables: must be a list of tables"));
  EXPECT_THAT(tables_.refusal("tables: [{file: a.csv}]"),
              HasSubstr("tables.0.messages: must be a list of messages"));
}

TEST_F(Refusals, CellsThatAreNoNumbers) {
  EXPECT_THAT(refusal_of("t,x\n1,2\n2,abc\n"),
              HasSubstr("a.csv:3: column 2 (x) = 'abc': is no finite number"));
  EXPECT_THAT(
      refusal_of("t,x\n1,nan\n"),
      HasSubstr(
          "a.csv:2: column 2 (x) = 'nan': is no finite number; if it means that there is none, list it under gaps"));
  EXPECT_THAT(refusal_of("t,x\n1,\n"), HasSubstr("a.csv:2: column 2 (x) = ''"));
  EXPECT_THAT(refusal_of("t,x\n1,2 m\n"), HasSubstr("a.csv:2: column 2 (x) = '2 m'"));
  EXPECT_THAT(refusal_of("t,x\nsoon,2\n"), HasSubstr("a.csv:2: column 1 (t) = 'soon': is no stamp in s"));
  EXPECT_THAT(refusal_of("t,x\n-1,2\n"),
              HasSubstr("a.csv:2: column 1 (t) = '-1': a stamp must lie in 0 ... 2147483647 s"));
  EXPECT_THAT(refusal_of("t,x\n2147483648,2\n"), HasSubstr("a stamp must lie in"));
  EXPECT_THAT(
      refusal_of("t,x\n1,21\n", {.field = "pose.pose.position.x: {column: x, unit: km, min: -20, max: 20}"}),
      HasSubstr("a.csv:2: column 2 (x) = '21': must be between -20 and 20 km"));
  EXPECT_THAT(refusal_of("t,a,b,c\n1,2,-3,4\n", {.type = "sensor_msgs/msg/LaserScan",
                                                 .field = "ranges: {columns: a..c, min: 0}",
                                                 .constant = ""}),
              HasSubstr("a.csv:2: column 3 (b) = '-3': must be between 0 and .inf"));
  EXPECT_THAT(refusal_of("t,x\n1,0.5\n",
                         {.type = "sensor_msgs/msg/NavSatFix", .field = "status.status: x", .constant = ""}),
              HasSubstr("a.csv:2: column 2 (x) = '0.5': must be a whole number from -128 to 127"));
}

TEST_F(Refusals, RowsOfAnotherLength) {
  EXPECT_THAT(refusal_of("t,x\n1,2\n2,3,4\n"), HasSubstr("a.csv:3: 3 cells where 2 are expected"));
  EXPECT_THAT(refusal_of("t,x\n1\n"), HasSubstr("a.csv:2: 1 cells where 2 are expected"));
  EXPECT_THAT(refusal_of("t,x,x\n"), HasSubstr("a.csv:1: two columns are named 'x'"));
  EXPECT_THAT(refusal_of(""), HasSubstr("a.csv:1: the header is missing"));
  EXPECT_THAT(
      refusal_of("1,2\n2\n", {.table = "", .stamp = "{column: 1}", .field = "pose.pose.position.x: 2"}),
      HasSubstr("a.csv:2: 1 cells where 2 are expected"));
}

TEST_F(Refusals, TablesThatNobodyNamesOrGives) {
  const ColumnsFile file = read_columns_file(tables_.write("columns.yaml", columns({})));
  EXPECT_THROW(import_tables(file, {tables_ / "none.csv"}), std::runtime_error);
  const auto other = tables_.write("other.csv", "t,x\n");
  EXPECT_THAT(
      [&] {
        import_tables(file, {tables_ / "a.csv", other});
      },
      testing::ThrowsMessage<std::runtime_error>(HasSubstr("other.csv: no table of")));
  std::filesystem::remove(tables_ / "a.csv");
  EXPECT_THAT(refusal({}),
              HasSubstr("columns.yaml:3: tables.0.file = a.csv: no table of this name is given"));
}

TEST_F(Refusals, LinesThatNobodyChooses) {
  const std::string lines =
      "tables:\n  - file: a.csv\n    separator: whitespace\n    stamp: {column: t}\n    columns: [word, t, x]\n    messages:\n"
      "      - {line: ODOM, topic: /odom, type: nav_msgs/msg/Odometry, fields: {pose.pose.position.x: x}}\n";
  tables_.write("a.csv", "ODOM 1 2\nODOMETER 2 3\n");
  EXPECT_THAT(tables_.refusal(lines),
              HasSubstr("a.csv:2: column 1 = 'ODOMETER': no message is made of lines that begin so"));
}

// Whatever bytes are written into the files: messages of the type, or a refusal.
TEST_F(Refusals, NoBytesBreakAnImport) {
  const std::string file =
      "log: {name: l, parameters: {wheel_separation: 0.4}}\ntables:\n  - file: a.csv\n    separator: whitespace\n"
      "    messages:\n      - line: W\n        columns: [word, n, 'r[n]', x, time, ...]\n"
      "        stamp: {column: time, unit: ms, on_falling: drop, on_duplicate: keep}\n        topic: /scan\n"
      "        type: sensor_msgs/msg/LaserScan\n        fields:\n"
      "          ranges: {columns: r, unit: mm, gaps: {nan: nan, 0: inf}, reverse: true}\n"
      "          angle_min: {by_count: {2: -90, 3: -45}, of: r, unit: deg, turning: clockwise}\n"
      "          scan_time: {column: x, unit: ms, min: 0, max: 100}\n        constants: {angle_max: 90 deg}\n";
  const std::string table = "W 2 100 nan 5 0 host\nW 3 1 0 3 7 1.5 host\n";
  constexpr std::string_view kBytes = "0123456789-+.eE[]{}:,*#'\"naif \n\t\r~\0\xff";
  std::mt19937 random(12);
  const auto mutated = [&](std::string text) {
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      const char byte = kBytes[random() % kBytes.size()];
      switch (random() % 3) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        default:
          text.erase(at, 1 + random() % 4);
      }
    }
    return text;
  };
  int imported = 0;
  constexpr int kMutants = 1000;
  for (int i = 0; i < kMutants; ++i) {
    tables_.write("a.csv", i % 2 == 0 ? mutated(table) : table);
    try {
      const ImportedLog log = tables_.import(i % 2 == 0 ? file : mutated(file));
      for (const ImportedMessage& m : log.messages) {
        const TypeDescription* type = find_type(log.topics.at(m.topic).type);
        std::string reason;
        ASSERT_TRUE(type != nullptr && validate(*type, m.data, &reason)) << reason;
      }
      ++imported;
    } catch (const std::runtime_error& error) {
      ASSERT_THAT(error.what(), AnyOf(HasSubstr("a.csv"), HasSubstr("columns.yaml")));
    }
  }
  // Some changes do no harm, and most do: both ways were tried.
  EXPECT_GT(imported, kMutants / 20);
  EXPECT_LT(imported, kMutants * 19 / 20);
}

// Whole, or not there at all.
TEST_F(Refusals, NoHalfBagIsLeft) {
  const auto files = [this] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(tables_.folder())) count += entry.exists();
    return count;
  };
  const ImportedLog log = tables_.import(columns({}));
  const std::size_t before = files();
  write_bag(log, tables_ / "out.mcap");
  EXPECT_EQ(files(), before + 1);
  EXPECT_EQ(bag::open_bag(tables_ / "out.mcap")->message_count(), 2U);
  EXPECT_THAT([&] { write_bag(log, tables_ / "out.mcap"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("out.mcap exists already")));
  write_bag(log, tables_ / "folder");
  const auto bag = bag::open_bag(tables_ / "folder");
  EXPECT_EQ(bag->message_count(), 2U);
  EXPECT_EQ(bag->metadata().at("log").at("name"), "l");
  EXPECT_TRUE(std::filesystem::exists(tables_ / "folder/folder_0.mcap"));
  EXPECT_EQ(files(), before + 2);
  // In memory it is the same bag.
  const auto in_memory = as_bag(log);
  EXPECT_EQ(in_memory->start(), bag->start());
  EXPECT_EQ(in_memory->end(), bag->end());
  EXPECT_EQ(in_memory->metadata().at("log"), bag->metadata().at("log"));
  const bag::BagSelection second{.start = Time::seconds(2), .topics = std::set<std::string>{"/odom"}};
  for (const bag::Bag* one : {in_memory.get(), bag.get()}) {
    const auto messages = one->messages(second);
    bag::BagMessage message;
    ASSERT_EQ(messages->next(message), bag::Step::message);
    EXPECT_EQ(message.log_time, Time::seconds(2));
    EXPECT_TRUE(std::ranges::equal(message.data, log.messages.at(1).data));
    EXPECT_EQ(messages->next(message), bag::Step::end);
  }
  // A message that cannot be written ends it: the disk, here a file where the folder should be.
  const auto blocked = tables_.write("blocked", "");
  EXPECT_ANY_THROW(write_bag(log, blocked / "out.mcap"));
  EXPECT_EQ(files(), before + 3);
}

}  // namespace
}  // namespace bw::imports
