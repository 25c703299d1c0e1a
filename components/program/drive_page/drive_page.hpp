// One page of a finished drive, as a file that anybody can open and pass on.
#pragma once

#include <filesystem>
#include <string>

namespace bw {

/// Before anything is driven: throws std::runtime_error that names `option` where this program has no page.
void require_page(const std::string& option);

/// `bag`: a file or a folder. The file appears whole or not at all. Throws std::runtime_error: no page, no
/// bag, too long a bag, no room.
void write_drive_page(const std::filesystem::path& bag, const std::string& name,
                      const std::filesystem::path& html);

}  // namespace bw
