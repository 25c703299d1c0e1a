// Checksums of an MCAP file that reading its messages does not look at.
#pragma once

#include <vector>

#include "runtime/recording/bag/mcap_contents.hpp"

namespace bw::bag::mcap {

/// Of the data section, byte by byte, and of the attachments; metadata records must be what they say. Reads
/// the whole file once; without a summary only what the walk found.
[[nodiscard]] std::vector<Fault> verify(const ByteSource& file, const Contents& contents);

}  // namespace bw::bag::mcap
