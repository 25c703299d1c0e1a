#include "runtime/dds/library.hpp"

#include <string_view>

#include "runtime/dds/fast_dds.hpp"

namespace bw::dds {
namespace {

/// Fixed from `in_2` on, and from `in_3` on; no version where there is none yet.
struct Fault {
  std::string_view what;
  LibraryVersion in_2;
  LibraryVersion in_3;
};

constexpr LibraryVersion kNever = {99, 0, 0};
constexpr Fault kFaults[] = {
    {"CVE-2023-50257 and freed memory by DATA_FRAG (2023, 2024)", {2, 14, 0}, {3, 0, 0}},
    {"CVE-2025-24807 (January 2025)", {2, 14, 6}, {3, 1, 2}},
    {"CVE-2025-62599 to 62603, 64098 (October 2025)", {2, 14, 6}, {3, 2, 4}},
    {"CVE-2025-62799, 64438: DATA_FRAG, endless GAP (November 2025)", {2, 14, 6}, {3, 2, 4}},
    {"CVE-2025-65016, CVE-2026-22590", {2, 14, 6}, {3, 2, 4}},
    {"CVE-2026-22591 (March 2026)", kNever, {3, 2, 5}},
    {"parsers of access control and several of deserialisation, CVE-2025-67108 (May to July 2026)",
     kNever,
     {3, 2, 5}},
};

}  // namespace

LibraryVersion library_version() {
  return {fast_dds::kVersion[0], fast_dds::kVersion[1], fast_dds::kVersion[2]};
}

std::string to_string(const LibraryVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.micro);
}

std::vector<std::string> known_faults(const LibraryVersion& version) {
  std::vector<std::string> faults;
  for (const Fault& fault : kFaults) {
    if (version < (version.major < 3 ? fault.in_2 : fault.in_3)) faults.emplace_back(fault.what);
  }
  return faults;
}

}  // namespace bw::dds
