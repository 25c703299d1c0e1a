// A small graph with everything in it, and how a changed one is given right checksums
// (components/slam/graph_file.md).
#pragma once

#include <cstdint>
#include <string>

#include <zlib.h>

#include "components/slam/graph_file.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam::test {

inline constexpr Pose2 kStart{3.0, -2.0, 0.5};

/// Once round the corridors and a little farther, seen by 60 beams on cells of 20 cm: some 100 kB.
inline const std::string& small_graph() {
  static const std::string bytes = [] {
    const SlamOptions options{.resolution = 0.2};
    const std::vector<Vector2> corners{{-5.0, -4.0}, {5.0, -4.0},  {5.0, 4.0},
                                       {-5.0, 4.0},  {-5.0, -4.0}, {1.0, -4.0}};
    const std::vector<Pose2> X_WB = drive_along(corners, 0.2);
    const std::vector<Pose2> X_OB = odometry_of(X_WB, 0.01, 0.01);
    Scanner scanner(square_of_corridors(), 0.01, 1, {.beams = 60});
    Slam slam(options);
    for (std::size_t k = 0; k < X_WB.size(); ++k)
      slam.add(scanner.scan(Time::seconds(0.4 * static_cast<double>(k)), X_WB[k], options), X_OB[k]);
    return graph_bytes({kStart, slam.save()});
  }();
  return bytes;
}

inline std::uint64_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::uint64_t sum = 0;
  for (int i = 0; i < size; ++i)
    sum |= std::uint64_t{static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)])} << (8 * i);
  return sum;
}
inline void put_at(std::string& bytes, std::size_t at, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i)
    bytes[at + static_cast<std::size_t>(i)] = static_cast<char>(value >> (8 * i));
}

/// With the size of the file in its header and the checksum of each section, by zlib, as far as sections
/// can be told.
inline std::string sealed(std::string bytes) {
  if (bytes.size() < 20) return bytes;
  put_at(bytes, 12, bytes.size(), 8);
  for (std::size_t at = 20; at + 16 <= bytes.size();) {
    const std::uint64_t size = number_at(bytes, at + 4, 8);
    if (size > bytes.size() - at - 16) break;
    const auto length = static_cast<std::size_t>(size) + 12;
    put_at(bytes, at + length,
           crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + at), static_cast<uInt>(length)), 4);
    at += length + 4;
  }
  return bytes;
}

}  // namespace bw::slam::test
