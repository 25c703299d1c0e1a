// Where the pseudo-terminal of an emulated device is found, so that a process needs only its name.
#pragma once

#include <filesystem>
#include <string>

namespace bw {

/// A link below XDG_RUNTIME_DIR or the folder of temporary files, of this user, domain and device ("base",
/// "laser").
std::filesystem::path emulator_path(const std::string& name, int domain);

}  // namespace bw
