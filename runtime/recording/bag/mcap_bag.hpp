// One MCAP file as a bag.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/recording/bag/bag.hpp"

namespace bw::bag {

/// Throws std::runtime_error naming the file for one that is no MCAP file.
[[nodiscard]] std::unique_ptr<Bag> open_mcap_file(const std::filesystem::path& file);

}  // namespace bw::bag
