// One SQLite file of rosbag2 (`.db3`, schema versions 1 to 4) as a bag. Read only; the file is never changed.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/recording/bag/bag.hpp"

namespace bw::bag {

/// Throws std::runtime_error naming the file and what is wrong for one that is no such bag.
[[nodiscard]] std::unique_ptr<Bag> open_sqlite_file(const std::filesystem::path& file);

}  // namespace bw::bag
