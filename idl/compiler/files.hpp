// The compiler's files: read whole, written only where they change.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// The files at `paths`, relative to `root`, sorted. Throws std::runtime_error naming the file (and line).
[[nodiscard]] std::vector<File> read_interfaces(const std::filesystem::path& root,
                                                std::vector<std::string> paths);

/// <package>/<msg|srv|action>/<Name>.idl below `root`; none of distros/<distro>/.
[[nodiscard]] std::vector<std::string> find_interfaces(const std::filesystem::path& root);

/// A file whose text stays the same is left alone, so that its users are not compiled again.
void write(const std::filesystem::path& path, const std::string& text);

/// Throws std::runtime_error, before anything is written, where a file exists that does not carry `mark`:
/// somebody else wrote it.
void write_all(const std::filesystem::path& folder, const std::map<std::string, std::string>& texts,
               const std::string& mark);

}  // namespace bw::idl
