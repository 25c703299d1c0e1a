// A text file, compressed by gzip or not: what its first bytes say counts, not its name.
#pragma once

#include <filesystem>
#include <istream>
#include <memory>

namespace bw::imports {

/// Lines of the text itself, whichever way it is stored. Throws std::runtime_error naming the file for what
/// is no file that can be read; so does reading, with the byte of the file, where compressed data are cut or
/// damaged.
std::unique_ptr<std::istream> open_text(const std::filesystem::path& file);

}  // namespace bw::imports
