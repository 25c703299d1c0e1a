// A client of one distribution at a server of another: the names match, the fields do not, and Humble sends no hash that could tell.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "tests/components/messages/every_nav2_type.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::test {
namespace {

constexpr std::uint64_t kSeed = 14;
constexpr int kPayloads = 100;

/// How many of a hundred random messages `From` a reader of `To` takes. What it takes it must have understood as a message of
/// its own, whole to its last byte; what it refuses it must give a reason for.
template <class From, class To>
int taken() {
  RandomPayload payload(kSeed, 3);
  int count = 0;
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < kPayloads; ++i) {
    const std::vector<std::uint8_t> sent = payload(MessageTraits<From>::description());
    To message;
    std::string reason;
    if (!deserialize(sent, message, &reason)) {
      EXPECT_NE(reason.find("byte "), std::string::npos) << reason;
      continue;
    }
    ++count;
    serialize(message, bytes);
    EXPECT_LE(bytes.size(), sent.size()) << MessageTraits<To>::ros_name;
    To again;
    EXPECT_TRUE(deserialize(bytes, again) && again == message) << MessageTraits<To>::ros_name;
    if (MessageTraits<From>::type_hash == MessageTraits<To>::type_hash) {
      EXPECT_EQ(bytes, sent) << MessageTraits<To>::ros_name;
    }
  }
  return count;
}

template <class From, class To>
void mix() {
  every_nav2_type<From, To>([]<class M, class N>() {
    const int count = taken<M, N>();
    if (MessageTraits<M>::type_hash == MessageTraits<N>::type_hash) {
      EXPECT_EQ(count, kPayloads) << MessageTraits<M>::ros_name;
    }
    std::cerr << MessageTraits<M>::ros_name << " " << count << "\n";
  });
}

TEST(Nav2MixedLayouts, HumbleToJazzy) { mix<HumbleNav2, JazzyNav2>(); }
TEST(Nav2MixedLayouts, HumbleToKilted) { mix<HumbleNav2, KiltedNav2>(); }
TEST(Nav2MixedLayouts, HumbleToLyrical) { mix<HumbleNav2, LyricalNav2>(); }
TEST(Nav2MixedLayouts, JazzyToHumble) { mix<JazzyNav2, HumbleNav2>(); }
TEST(Nav2MixedLayouts, JazzyToKilted) { mix<JazzyNav2, KiltedNav2>(); }
TEST(Nav2MixedLayouts, JazzyToLyrical) { mix<JazzyNav2, LyricalNav2>(); }
TEST(Nav2MixedLayouts, KiltedToHumble) { mix<KiltedNav2, HumbleNav2>(); }
TEST(Nav2MixedLayouts, KiltedToJazzy) { mix<KiltedNav2, JazzyNav2>(); }
TEST(Nav2MixedLayouts, KiltedToLyrical) { mix<KiltedNav2, LyricalNav2>(); }
TEST(Nav2MixedLayouts, LyricalToHumble) { mix<LyricalNav2, HumbleNav2>(); }
TEST(Nav2MixedLayouts, LyricalToJazzy) { mix<LyricalNav2, JazzyNav2>(); }
TEST(Nav2MixedLayouts, LyricalToKilted) { mix<LyricalNav2, KiltedNav2>(); }

}  // namespace
}  // namespace bw::test
