// Strict reading of small tables of numbers. Every complaint names file and line.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

struct CsvRow {
  std::size_t line = 0;  ///< in the file, from 1
  std::vector<double> values;
};

enum class CsvNumbers {
  finite,
  or_infinite  ///< "inf" is a value, such as a range without return; NaN is none
};

/// Reads comma-separated numbers under a first line that must be exactly `header`. Windows line ends are
/// accepted, an empty last line too. Throws std::runtime_error ("file:line: what is wrong") otherwise; of a
/// wrong header it tells the first column that differs.
std::vector<CsvRow> read_csv(std::istream& input, const std::string& file, std::string_view header,
                             CsvNumbers numbers = CsvNumbers::finite);

/// Opens the file; throws std::runtime_error when that fails.
std::vector<CsvRow> read_csv(const std::string& file, std::string_view header,
                             CsvNumbers numbers = CsvNumbers::finite);

/// One number of a table in another form, with the same complaints.
double to_number(std::string_view text, const std::string& file, std::size_t line,
                 CsvNumbers numbers = CsvNumbers::finite);

/// Next line without its line end; false at the end of the file, a complaint when it is far too long.
bool next_line(std::istream& input, std::string& text, const std::string& file, std::size_t line);

/// Printable start, quoted, of a text from a file that may hold anything: for complaints.
std::string excerpt(std::string_view text);

[[noreturn]] void fail_at(const std::string& file, std::size_t line, const std::string& what);

}  // namespace bw
