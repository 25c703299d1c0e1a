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

/// Reads comma-separated finite numbers under a first line that must be exactly `header`. Windows line ends
/// are accepted, an empty last line too. Throws std::runtime_error ("file:line: what is wrong") otherwise.
std::vector<CsvRow> read_csv(std::istream& input, const std::string& file, std::string_view header);

/// Opens the file; throws std::runtime_error when that fails.
std::vector<CsvRow> read_csv(const std::string& file, std::string_view header);

[[noreturn]] void fail_at(const std::string& file, std::size_t line, const std::string& what);

}  // namespace bw
