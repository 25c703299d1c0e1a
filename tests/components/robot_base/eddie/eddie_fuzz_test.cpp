// Damaged replies: no crash, nothing but what was commanded is written, in step again within two lines.
//   BANDWAGON_SERIAL_FUZZ=1000000 build/asan/bin/test_eddie --gtest_filter='*Fuzz*'
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "components/robot_base/eddie/dialogue.hpp"
#include "components/robot_base/eddie/eddie.hpp"
#include "components/robot_base/eddie/text.hpp"
#include "tests/components/robot_base/fuzz.hpp"
#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::eddie {
namespace {

Bytes some_line(Random& random) {
  static const std::string kLines[] = {"\r",
                                       "0014\r",
                                       "000000FF FFFFFC18\r",
                                       "ERROR - Overflow\r",
                                       "ERROR\r",
                                       "3E8 000\r",
                                       "333 1D5 000 000 000 000 000 BF6\r"};
  return bytes_of(kLines[below(random, std::size(kLines))]);
}

// Whatever comes while one reply is waited for, and after it: the next request but one has its own reply.
TEST(EddieFuzz, InStepAgainWithinTwoLines) {
  Random random(163);
  const int streams = fuzz_streams();
  for (int i = 0; i < streams; ++i) {
    ScriptedLink::Wire wire;
    ScriptedLink link(wire);
    Dialogue dialogue(Duration::milliseconds(80));
    Time now = Time::seconds(1.0);
    Bytes bytes = below(random, 4) == 0 ? noise(random, 1 + below(random, 300)) : some_line(random);
    damage(random, bytes);
    ASSERT_TRUE(dialogue.ask(now, Request::counts, "DIST\r", link));
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min(bytes.size() - at, 1 + below(random, 60));
      now = now + Duration::milliseconds(10);
      dialogue.take(now, std::span(bytes).subspan(at, size));
      at += size;
    }
    int lost = 0;
    for (int request = 0; request < 3; ++request) {
      for (int wait = 0; wait < 40 && !dialogue.is_free(now); ++wait) {
        now = now + Duration::milliseconds(10);
        dialogue.take(now, {});
      }
      ASSERT_TRUE(dialogue.is_free(now)) << "stream " << i;
      ASSERT_TRUE(dialogue.ask(now, Request::counts, "DIST\r", link));
      now = now + Duration::milliseconds(10);
      const std::string text = "0000000" + std::to_string(request) + " FFFFFFFF\r";
      const auto reply = dialogue.take(now, bytes_of(text));
      const auto read = reply && !reply->is_timeout ? distances_of(reply->text) : std::nullopt;
      if (!read || read->left != request) ++lost;
    }
    ASSERT_LE(lost, 1) << "stream " << i;
  }
}

TEST(EddieFuzz, NothingButTheCommandIsWritten) {
  Random random(164);
  const int streams = fuzz_streams();
  Robot robot;
  robot.ticks_per_revolution = 144;
  for (int i = 0; i < streams; ++i) {
    const bool is_noise = i % 2 == 0;
    ScriptedLink::Wire wire;
    Eddie eddie({}, robot, std::make_unique<ScriptedLink>(wire));
    Time now = Time::seconds(5.0);
    std::size_t answered = 0;
    for (int step = 0; step < 40; ++step) {
      now = now + Duration::milliseconds(10);
      eddie.poll(now);
      eddie.command(now, {0.3, 0.3});
      if (is_noise) {
        wire.put(noise(random, below(random, 20)));
      } else if (answered < wire.from_host.size()) {
        const Bytes& request = wire.from_host.back();
        const std::string word(request.begin(), request.end());
        Bytes reply = bytes_of(word.starts_with("VER\r") || word.starts_with("HWVER") ? "0014\r" : "\r");
        if (below(random, 6) == 0) damage(random, reply);
        wire.put(reply);
      }
      answered = wire.from_host.size();
    }
    ASSERT_FALSE(wire.from_host.empty());
    ASSERT_EQ(wire.from_host.front(), bytes_of("STOP 0\r"));
    for (const Bytes& bytes : wire.from_host) {
      const std::string line(bytes.begin(), bytes.end());
      const bool moves = line.starts_with("GO");
      ASSERT_TRUE(!moves || (!is_noise && line == "GOSPD 5A 5A\r")) << "stream " << i << ": " << line;
      ASSERT_TRUE(line.ends_with('\r'));
    }
  }
}

}  // namespace
}  // namespace bw::eddie
