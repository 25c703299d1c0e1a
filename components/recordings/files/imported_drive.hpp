// A drive from tables, by a columns file, without a bag on disk.
#pragma once

#include <filesystem>
#include <vector>

#include "components/recordings/files/drive_of_bag.hpp"

namespace bw {

/// Throws what the import and drive_of_bag() throw.
BagDrive import_drive(const std::filesystem::path& columns_file,
                      const std::vector<std::filesystem::path>& tables);

}  // namespace bw
