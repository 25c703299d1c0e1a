// The verbs of `bandwagon bag`. Each returns the exit status, and throws std::runtime_error for what is no
// bag and for what cannot be written.
#pragma once

#include <filesystem>
#include <string>

namespace bw::cli {

/// What a bag says of itself, without a walk over its messages. 0.
int bag_info(const std::filesystem::path& path, bool as_json);

/// Reads every byte: rates, gaps, damage, order, content, clocks. 1 when the bag is not sound.
int bag_check(const std::filesystem::path& path, bool as_json);

/// Saves what can be saved of a damaged MCAP file. 1 when something is lost.
int bag_recover(const std::filesystem::path& path, const std::filesystem::path& out, bool as_json);

/// Writes it again as MCAP. 1 when something could not be read.
int bag_convert(const std::filesystem::path& path, const std::filesystem::path& out,
                const std::string& compression, bool as_json);

}  // namespace bw::cli
