// `bandwagon bench bag`: how fast bags are written, opened, searched and read.
#pragma once

#include <cstdint>
#include <string>

namespace bw {

struct BenchBagArguments {
  std::string folder = ".";          ///< where bags are made, and deleted
  double size_gb = 1.0;              ///< of messages in the bag that is opened and searched [10^9 bytes]
  std::string compression = "none";  ///< of that bag: none, lz4, zstd
  double write_gb = 1.0;             ///< of messages written in each compression [10^9 bytes]
  std::string read;                  ///< an existing bag to open, search and read; then nothing is written
  int seeks = 100;                   ///< random positions
  bool keep = false;                 ///< does not delete the large bag
  std::uint64_t seed = 1;
  std::string json;  ///< output file; empty: none
};

/// Prints figures to stdout, writes JSON. Returns the exit status (0). Throws std::runtime_error: no such
/// folder, not enough space, no bag.
int bench_bag(const BenchBagArguments& arguments);

}  // namespace bw
