// Pictures of maps: PGM (P2, P5) and PNG into cells. The file is not trusted: sizes are checked against the
// file's own length and a cap before anything is allocated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace bw {

inline constexpr std::size_t kMaxMapCells = std::size_t{64} << 20;
inline constexpr std::size_t kMaxImageBytes =
    (std::size_t{128} << 20) + 4096;  ///< of a file, and of decoded pixels

struct MapImage {
  int width = 0;
  int height = 0;
  std::vector<std::int8_t> cells;  ///< row-major, the lowest row of the picture first
};

/// Cell value of a pixel, from its shade: 0 black to 1 white, the mean of the colours.
using CellOfShade = std::function<std::int8_t(double shade)>;

/// Transparent pixels (any alpha below the largest) are unknown. Throws ConfigError naming the file and what
/// is wrong.
MapImage read_map_image(const std::filesystem::path& path, const CellOfShade& cell_of_shade);

}  // namespace bw
