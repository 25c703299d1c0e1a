// Damaged streams: no crash, nothing but what was commanded is written, in step again within two packets.
//   BANDWAGON_SERIAL_FUZZ=1000000 build/asan/bin/test_kobuki --gtest_filter='*Fuzz*'
#include <memory>

#include <gtest/gtest.h>

#include "components/robot_base/kobuki/feedback.hpp"
#include "components/robot_base/kobuki/kobuki.hpp"
#include "components/robot_base/kobuki/packet_reader.hpp"
#include "tests/components/robot_base/fuzz.hpp"
#include "tests/components/robot_base/kobuki/packets.hpp"

namespace bw::kobuki {
namespace {

Bytes stream(Random& random, int packets) {
  Bytes all;
  for (int i = 0; i < packets; ++i) {
    const Bytes one = whole_packet({.stamp = static_cast<int>(below(random, 65'536)),
                                    .left = static_cast<int>(below(random, 65'536)),
                                    .right = static_cast<int>(below(random, 65'536)),
                                    .bumper = static_cast<std::uint8_t>(below(random, 256)),
                                    .charger = static_cast<std::uint8_t>(below(random, 256))});
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

TEST(KobukiFuzz, InStepAgainWithinTwoPackets) {
  Random random(161);
  const int streams = fuzz_streams();
  for (int i = 0; i < streams; ++i) {
    Bytes bytes = below(random, 8) == 0 ? noise(random, 1 + below(random, 300)) : stream(random, 3);
    damage(random, bytes);
    // What begins like a packet with the longest payload of all.
    if (below(random, 4) == 0) bytes.insert(bytes.end(), {0xAA, 0x55, 0xFF});
    const std::size_t damaged = bytes.size();
    constexpr int kClean = 4;
    for (int k = 0; k < kClean; ++k) bytes = joined({bytes, whole_packet({.stamp = 50'000 + k})});
    PacketReader reader;
    std::vector<int> stamps;
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min(bytes.size() - at, 1 + below(random, 120));
      reader.add(std::span(bytes).subspan(at, size));
      at += size;
      for (auto payload = reader.next(); !payload.empty(); payload = reader.next()) {
        const Feedback feedback = parse(payload);
        stamps.push_back(feedback.core ? feedback.core->stamp : -1);
      }
    }
    // The first of the four may be lost.
    ASSERT_GE(stamps.size(), 3U) << "stream " << i << ", " << damaged << " bytes";
    for (int k = 1; k < kClean; ++k)
      ASSERT_EQ(stamps[stamps.size() - kClean + static_cast<std::size_t>(k)], 50'000 + k) << "stream " << i;
  }
}

TEST(KobukiFuzz, NothingButTheCommandIsWritten) {
  Random random(162);
  const int streams = fuzz_streams();
  const WheelSpeeds wheels{0.2, 0.2};
  const Bytes ahead = base_control({200, 0}), stop = base_control({}), request = request_versions();
  for (int i = 0; i < streams; ++i) {
    const bool is_noise = i % 2 == 0;
    Bytes bytes = is_noise ? noise(random, 400) : stream(random, 4);
    if (!is_noise) damage(random, bytes);
    bytes.push_back(0);  // damage may leave nothing
    ScriptedLink::Wire wire;
    Kobuki kobuki({}, {0.035, 0.035}, std::make_unique<ScriptedLink>(wire));
    Time now = Time::seconds(5.0);
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min(bytes.size() - at, 1 + below(random, 120));
      wire.put(std::span(bytes).subspan(at, size));
      at += size;
      now = now + Duration::milliseconds(10);
      const Readings readings = kobuki.poll(now);
      kobuki.command(now, wheels);
      for (const EncoderCounts& counts : readings.counts)
        ASSERT_LE(counts.time, now + Duration::milliseconds(40'000));
    }
    ASSERT_FALSE(wire.from_host.empty());
    ASSERT_EQ(wire.from_host.front(), stop);
    for (const Bytes& written : wire.from_host)
      ASSERT_TRUE(written == stop || (!is_noise && (written == ahead || written == request)))
          << "stream " << i;
  }
}

}  // namespace
}  // namespace bw::kobuki
