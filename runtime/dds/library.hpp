// Which Fast DDS this program was built with, and what is known to be wrong with it.
#pragma once

#include <compare>
#include <string>
#include <vector>

namespace bw::dds {

struct LibraryVersion {
  int major = 0;
  int minor = 0;
  int micro = 0;
  auto operator<=>(const LibraryVersion&) const = default;
};

LibraryVersion library_version();
std::string to_string(const LibraryVersion& version);  ///< 3.1.2

/// Published vulnerabilities that the sources of this version have, a line each. By the history of Fast DDS'
/// releases up to July 2026; what a distribution has patched besides is not known here.
std::vector<std::string> known_faults(const LibraryVersion& version);

}  // namespace bw::dds
