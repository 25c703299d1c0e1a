// Tables of numbers: what is said of a header that is not the one expected.
#include "components/files/csv_file.hpp"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace bw {
namespace {

std::string complaint(const std::string& header, const std::string& file) {
  std::istringstream input(file);
  try {
    read_csv(input, "t.csv", header);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

/// time, then r1 to r512: the header of a scan table.
std::string scan_header() {
  std::string text = "time";
  for (int i = 1; i <= 512; ++i) text += ",r" + std::to_string(i);
  return text;
}

TEST(CsvFile, OfAWrongHeaderTheFirstColumnThatDiffersIsTold) {
  std::string found = scan_header();
  const std::string swapped = "r300,";
  found.replace(found.find(swapped), swapped.size(), "r3OO,");  // letters for digits
  EXPECT_EQ(complaint(scan_header(), found + "\n"),
            "t.csv:1: column 301 of the header must be 'r300', found 'r3OO'");
}

TEST(CsvFile, AHeaderThatEndsTooEarlyOrTooLateIsTold) {
  EXPECT_EQ(complaint("a,b,c", "a,b\n"), "t.csv:1: column 2 of the header is the last, but 'c' must follow");
  EXPECT_EQ(complaint("a,b", "a,b,c\n"), "t.csv:1: column 2 of the header must be the last, found more");
  EXPECT_EQ(complaint("a,b", ""), "t.csv:1: the header is missing");
  EXPECT_EQ(complaint("a,b", "\n"), "t.csv:1: column 1 of the header must be 'a', found ''");
  EXPECT_EQ(complaint("a,b", "a,b\r\n1,2\n"), "none");
}

TEST(CsvFile, ALongOrUnprintableNameIsCutAndMadePrintable) {
  EXPECT_EQ(complaint("a", std::string(60, 'x') + "\n"),
            "t.csv:1: column 1 of the header must be 'a', found '" + std::string(40, 'x') + "...'");
  EXPECT_EQ(complaint("a", "\x01\n"), "t.csv:1: column 1 of the header must be 'a', found '?'");
}

}  // namespace
}  // namespace bw
