// A file of the project's config/, wherever the program was started.
#pragma once

#include <filesystem>

namespace bw {

/// `path` is relative to the project's folder (config/suites/hallway.yaml): looked for in the current folder,
/// as installed beside the program, and in the project that the program was built in. Throws
/// std::runtime_error where it is not found.
std::filesystem::path project_file(const std::filesystem::path& path);

}  // namespace bw
