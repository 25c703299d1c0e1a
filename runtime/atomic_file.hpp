// Writes a file so that a crash leaves either the old content or the new one, never a part.
#pragma once

#include <filesystem>
#include <string_view>

namespace bw {

/// Makes missing folders. A file that is replaced keeps its mode; a link is replaced itself, and what it
/// leads to stays as it is. Throws std::runtime_error naming the path and the system's reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace bw
