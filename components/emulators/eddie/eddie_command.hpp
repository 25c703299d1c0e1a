// A line to an Eddie board as a command, or the reason why it is none: the command set's document, version
// 1.2. Numbers are hexadecimal, signed ones in two's complement of their width.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/emulators/eddie/eddie_options.hpp"
#include "components/emulators/eddie/line_editor.hpp"

namespace bw::emulators {

struct EddieCommand {
  std::string name;  ///< empty: a line without anything in it, or an error
  std::vector<std::int64_t> values;
  std::string error;  ///< as VERB 1 tells it
};

EddieCommand parse_line(const EditedLine& line, const EddieOptions& options);

}  // namespace bw::emulators
