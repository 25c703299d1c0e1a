// Units, stamps to the nanosecond, rows and the columns laid over them.
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>

#include "runtime/recording/import/column_layout.hpp"
#include "runtime/recording/import/stamp_text.hpp"
#include "runtime/recording/import/units.hpp"
#include "tests/runtime/recording/import/tables.hpp"

namespace bw::imports {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Units, ScaleToSi) {
  EXPECT_DOUBLE_EQ(unit_of("km/h")->scale, 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(unit_of("deg/s")->scale, std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(unit_of("mm^2")->scale, 1e-6);
  EXPECT_DOUBLE_EQ(unit_of("cm/s^2")->scale, 0.01);
  EXPECT_EQ(unit_of("deg/s")->powers, kTurnRate);
  EXPECT_EQ(unit_of("rpm")->powers, kTurnRate);
  EXPECT_EQ(unit_of("ms")->powers, kTime);
  for (const char* const text : {"", "degree", "m/", "/s", "m^3", "m/s/s", "M"})
    EXPECT_FALSE(unit_of(text)) << text;
}

TEST(StampText, IsExactForTimesOfToday) {
  const auto nanoseconds = [](const char* text, const char* unit) {
    return stamp_of_text(text, unit)->nanoseconds;
  };
  EXPECT_EQ(nanoseconds("1700000000.123456789", "s"), 1'700'000'000'123'456'789);
  EXPECT_EQ(nanoseconds("1700000000123456789", "ns"), 1'700'000'000'123'456'789);
  EXPECT_EQ(nanoseconds("1700000000123456.7895", "us"), 1'700'000'000'123'456'790);  // rounded
  EXPECT_EQ(nanoseconds("-0.5", "ms"), -500'000);
  EXPECT_EQ(nanoseconds(".25", "s"), 250'000'000);
  EXPECT_EQ(nanoseconds("7.", "ns"), 7);
  EXPECT_EQ(nanoseconds("1.5e3", "ms"), 1'500'000'000);
  EXPECT_EQ(nanoseconds("2", "h"), 7'200'000'000'000);
  for (const char* const text : {"", "x", "nan", "inf", "1e300", "1 2", "0x10", "9999999999999"})
    EXPECT_FALSE(stamp_of_text(text, "s")) << text;
}

std::vector<std::vector<std::string>> rows(const std::filesystem::path& file, const TableFormat& format) {
  TableReader reader(file, format);
  std::vector<std::vector<std::string>> all;
  for (Row row; reader.next(row);) all.push_back(row.cells);
  return all;
}

TEST(TableReader, ReadsWhatPeopleWrite) {
  const Tables tables;
  EXPECT_THAT(rows(tables.write("a.csv",
                                "\xEF\xBB\xBF"
                                "1, 2 ,\r\n\n# no row\n\"a,b\",\"c\",d"),
                   {.comment = "#"}),
              ElementsAre(ElementsAre("1", "2", ""), ElementsAre("a,b", "c", "d")));
  EXPECT_THAT(rows(tables.write("b.txt", "  A  1\t2  \nB\n"), {.separator = Separator::whitespace}),
              ElementsAre(ElementsAre("A", "1", "2"), ElementsAre("B")));
  EXPECT_THAT(rows(tables.write("c.tsv", "\t1\t\n"), {.separator = Separator::tab}),
              ElementsAre(ElementsAre("", "1", "")));
  EXPECT_THAT(
      rows(tables.write("d.csv", "x;y\n1,5;2\n"), {.separator = Separator::semicolon, .header = true}),
      ElementsAre(ElementsAre("1,5", "2")));
}

TEST(TableReader, RefusesWhatIsNoTable) {
  const Tables tables;
  EXPECT_THROW(TableReader(tables / "none.csv", {}), std::runtime_error);
  EXPECT_THROW(TableReader(tables.folder(), {}), std::runtime_error);
  EXPECT_THROW(TableReader(tables.write("e.csv", "\n\n"), {.header = true}), TableError);
  EXPECT_THROW(rows(tables.write("f.csv", "1,\"2\n"), {}), TableError);
  EXPECT_THROW(rows(tables.write("g.csv", std::string(1'100'000, '1')), {}), TableError);
}

std::string laid(const std::vector<std::string>& list, const std::vector<std::string>& cells) {
  ColumnLayout layout = ColumnLayout::of_list(list);
  try {
    layout.lay_over({.line = 3, .cells = cells}, "t");
  } catch (const TableError& error) {
    return error.what();
  }
  std::string text;
  for (std::size_t i = 0; i < list.size() && list[i] != "..."; ++i)
    text += std::to_string(layout.cells(i).first) + "+" + std::to_string(layout.cells(i).count) + " ";
  return text;
}

TEST(ColumnLayout, TheCountTellsWhereTheRestBegins) {
  EXPECT_EQ(laid({"word", "n", "r[n]", "x"}, {"W", "2", "5", "6", "7"}), "0+1 1+1 2+2 4+1 ");
  EXPECT_EQ(laid({"n", "r[n]", "x"}, {"0", "7"}), "0+1 1+0 1+1 ");
  EXPECT_EQ(laid({"t", "r[*]", "x", "y"}, {"1", "2", "3", "4", "5"}), "0+1 1+2 3+1 4+1 ");
  EXPECT_EQ(laid({"t", "r[2]"}, {"1", "2", "3"}), "0+1 1+2 ");
  EXPECT_EQ(laid({"t", "..."}, {"1", "2", "3"}), "0+1 ");
}

TEST(ColumnLayout, RowsThatDoNotFitAreRefused) {
  EXPECT_EQ(laid({"n", "r[n]", "x"}, {"3", "5", "6", "7"}), "t:3: 4 cells where 5 are expected");
  EXPECT_EQ(laid({"n", "r[n]", "x"}, {"1.5", "5", "6"}),
            "t:3: column 1 (n) = '1.5': must be a whole number, the count of 'r'");
  EXPECT_EQ(laid({"n", "r[n]"}, {"-1", "5"}),
            "t:3: column 1 (n) = '-1': must be a whole number, the count of 'r'");
  EXPECT_THAT(laid({"n", "r[n]"}, {"999999999999", "5"}), HasSubstr("must be a whole number"));
  EXPECT_EQ(laid({"a", "b"}, {"1", "2", "3"}), "t:3: 3 cells where 2 are expected");
  EXPECT_EQ(laid({"a", "r[*]", "b"}, {"1"}), "t:3: 1 cells where at least 2 are expected");
  for (const std::vector<std::string>& list : std::vector<std::vector<std::string>>{{"a", "a"},
                                                                                    {"r[n]", "n"},
                                                                                    {"...", "a"},
                                                                                    {"r[*]", "q[*]"},
                                                                                    {"r[*]", "n", "q[n]"},
                                                                                    {"r[*]", "..."},
                                                                                    {"[3]"}})
    EXPECT_THROW(ColumnLayout::of_list(list), std::invalid_argument);
}

TEST(ColumnLayout, ColumnsHaveNamesAndNumbers) {
  const ColumnLayout layout = ColumnLayout::of_header({"t", "r0", "r1", "r2"});
  EXPECT_EQ(layout.column("r1"), 2U);
  EXPECT_EQ(layout.column("1"), 0U);
  EXPECT_EQ(layout.columns("r0..r2"), std::pair(std::size_t{1}, std::size_t{3}));
  EXPECT_EQ(layout.columns("3.."), std::pair(std::size_t{2}, std::size_t{3}));
  for (const char* const text : {"5", "0", "q", "-1"})
    EXPECT_THROW(std::ignore = layout.column(text), std::invalid_argument) << text;
  for (const char* const text : {"r0", "r2..r0", "r0..q"})
    EXPECT_THROW(std::ignore = layout.columns(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace bw::imports
