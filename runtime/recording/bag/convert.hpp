// A bag written again as MCAP: another compression, a SQLite bag made MCAP, what is sound of a damaged one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/compression.hpp"

namespace bw::bag {

struct ConvertReport {
  std::uint64_t messages = 0;  ///< written
  std::uint64_t size = 0;      ///< of what was written [bytes]
  std::vector<BagFault> lost;  ///< what could not be read, and where
};

/// Messages by log time, with their bytes as they are, decoded or not; topics, attachments, metadata and
/// profile as well.
/// A topic without a schema gets that of this build if its type is known. `to` is as BagWriter takes it;
/// throws as that does.
ConvertReport convert(const Bag& from, const std::filesystem::path& to, Compression compression);

}  // namespace bw::bag
