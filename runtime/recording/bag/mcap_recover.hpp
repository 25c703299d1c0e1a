// Saves what can be saved of a damaged MCAP file: every whole chunk, also behind the damage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/recording/bag/mcap_contents.hpp"

namespace bw::bag::mcap {

struct RecoveryReport {
  std::uint64_t messages = 0;    ///< saved
  std::uint64_t lost_bytes = 0;  ///< of the file, passed over
  std::vector<Fault> faults;     ///< where and why
  bool was_whole = false;        ///< nothing was wrong
};

/// Writes a new file, with the compression of the old one, in the order of the old one. A chunk whose
/// checksum does not fit is lost, not passed on. Throws std::runtime_error when `from` is no MCAP file,
/// std::system_error when `to` exists or cannot be written.
RecoveryReport recover(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace bw::bag::mcap
