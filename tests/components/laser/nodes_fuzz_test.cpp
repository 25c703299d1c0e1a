// The stream of nodes with bytes changed, lost, doubled and put in: in step again soon, and nothing invented
// for long. The number of streams is BANDWAGON_SERIAL_FUZZ, 20,000 unless it says otherwise.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "components/laser/rplidar/answers.hpp"
#include "components/model/random.hpp"
#include "tests/components/laser/node_bytes.hpp"

namespace bw::laser {
namespace {

using Bytes = std::vector<std::uint8_t>;

int streams() {
  const char* const asked = std::getenv("BANDWAGON_SERIAL_FUZZ");
  return asked == nullptr ? 20'000 : std::max(1, std::atoi(asked));
}

constexpr int kBefore = 20;  // nodes before the damage
constexpr int kAfter = 60;

/// What the head turns before. Where ranges change little from node to node, bytes at a wrong place may
/// follow each other for long.
enum class Scene : std::uint8_t { clutter, wall, wall_with_noise, column };
constexpr int kScenes = 4;

double range_at(Scene scene, double degrees, double distance, Random& random) {
  switch (scene) {
    case Scene::clutter:
      return random.uniform(0.15, 12.0);
    case Scene::wall:
    case Scene::wall_with_noise: {
      const double ahead = std::max(0.1, std::abs(std::cos(degrees * 0.0174533)));
      const double noise = scene == Scene::wall ? 0.0 : random.uniform(-0.005, 0.005);
      return distance / ahead + noise;
    }
    case Scene::column:
      return distance;
  }
  return 0.0;
}

/// A head that rotates by about a degree a node.
Bytes sound_stream(Random& random, Scene scene, int nodes) {
  Bytes bytes = {0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81};
  const double first = random.uniform(0.0, 359.0);
  const double step = random.uniform(0.5, 1.8);
  const double distance = random.uniform(0.15, 1.5);
  double last = -1.0;
  for (int i = 0; i < nodes; ++i) {
    double angle = first + step * i;
    while (angle >= 359.99) angle -= 359.99;
    append_node(bytes, angle, range_at(scene, angle, distance, random), angle < last,
                static_cast<int>(random.bits() % 64));
    last = angle;
  }
  return bytes;
}

/// One accident within the node after kBefore others. Returns how many of those after it are not hurt.
void damage(Random& random, Bytes& bytes) {
  const auto at = static_cast<std::ptrdiff_t>(kHeaderSize + kBefore * kNodeSize + random.bits() % kNodeSize);
  const auto length = static_cast<std::ptrdiff_t>(1 + random.bits() % 9);
  switch (random.bits() % 4) {
    case 0:
      bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1U << random.bits() % 8);
      return;
    case 1:
      bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
      return;
    case 2: {
      Bytes noise(static_cast<std::size_t>(length));
      for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random.bits());
      bytes.insert(bytes.begin() + at, noise.begin(), noise.end());
      return;
    }
    default:
      for (auto i = at; i < at + length; ++i)
        bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(random.bits());
  }
}

/// In random pieces.
std::vector<Node> read_all(Random& random, AnswerReader& reader, const Bytes& bytes) {
  std::vector<Node> nodes;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t piece = std::min<std::size_t>(1 + random.bits() % 40, bytes.size() - at);
    const auto& received = reader.read(std::span(bytes).subspan(at, piece));
    nodes.insert(nodes.end(), received.nodes.begin(), received.nodes.end());
    at += piece;
  }
  return nodes;
}

/// How many of the last nodes of both are the same.
int same_at_end(const std::vector<Node>& a, const std::vector<Node>& b) {
  const auto differ = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  return static_cast<int>(differ.first - a.rbegin());
}

// Damage of up to 9 bytes hurts up to three nodes (two that it touches whole or in part, one by the bytes
// after them). "In step again within 2 nodes": of the 57 behind those all but two are read. A node at a wrong
// place that follows the one before, by chance, is given out before anybody can know: hence what is invented
// beside the flipped bits in ranges that nobody can see.
TEST(RplidarFuzz, IsInStepAgainWithinTwoNodes) {
  const int count = streams();
  std::array<int, kScenes> late{}, latest{}, invented{};
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const auto scene = static_cast<std::size_t>(i % kScenes);
    Bytes bytes = sound_stream(random, static_cast<Scene>(scene), kBefore + kAfter);
    AnswerReader sound_reader;
    const std::vector<Node> truth = read_all(random, sound_reader, bytes);
    ASSERT_EQ(truth.size(), static_cast<std::size_t>(kBefore + kAfter)) << i;
    damage(random, bytes);
    AnswerReader reader;
    const std::vector<Node> nodes = read_all(random, reader, bytes);
    const int lost = kAfter - 3 - same_at_end(nodes, truth);
    late[scene] += lost > 2 ? 1 : 0;
    latest[scene] = std::max(latest[scene], lost);
    invented[scene] += static_cast<int>(std::ranges::count_if(
        nodes, [&](const Node& node) { return std::ranges::find(truth, node) == truth.end(); }));
  }
  for (std::size_t scene = 0; scene < kScenes; ++scene) {
    const int streams_of_scene = std::max(1, count / kScenes);
    std::printf(
        "scene %zu, %d damaged streams: %d in step later than 2 nodes after the damage, the latest %d; %.3f nodes invented a stream\n",
        scene, streams_of_scene, late[scene], latest[scene],
        static_cast<double>(invented[scene]) / streams_of_scene);
    EXPECT_EQ(late[scene], 0);
    EXPECT_LE(invented[scene], streams_of_scene);
  }
}

// Nothing but noise, and noise after a sound header: no crash, memory bounded, and never a whole revolution
// of it.
TEST(RplidarFuzz, NoiseIsNoScan) {
  const int count = std::max(1, streams() / 20);
  std::uint64_t nodes_of_noise = 0;
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    Bytes bytes;
    const bool has_header = i % 2 == 0;
    if (has_header) bytes = {0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81};
    for (int k = 0; k < 2000; ++k) bytes.push_back(static_cast<std::uint8_t>(random.bits()));
    AnswerReader reader;
    const std::size_t nodes = read_all(random, reader, bytes).size();
    EXPECT_LT(nodes, has_header ? 40U : 1U) << "of 400 " << i;
    nodes_of_noise += nodes;
  }
  std::printf("noise after a header: %.1f of 400 possible nodes\n",
              2.0 * static_cast<double>(nodes_of_noise) / count);
}

}  // namespace
}  // namespace bw::laser
