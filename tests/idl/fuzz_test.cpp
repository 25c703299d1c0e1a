// Hostile payloads: whatever arrives, deserialize() neither throws nor crashes nor allocates out of
// proportion.
#include <gtest/gtest.h>

#include "runtime/wire/yaml.hpp"
#include "tests/idl/cdr_writer.hpp"
#include "tests/idl/every_message.hpp"
#include "tests/runtime/largest_allocation.hpp"

namespace bw::test {
namespace {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  void operator()(std::vector<std::uint8_t>& bytes) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(bytes);
  }

 private:
  void change(std::vector<std::uint8_t>& bytes) {
    const std::size_t at = below(bytes.size() + 1);
    switch (below(6)) {
      case 0:  // any byte, the encapsulation's among them
        if (at < bytes.size()) bytes[at] = static_cast<std::uint8_t>(random_());
        return;
      case 1:
        bytes.resize(at);
        return;
      case 2:
        bytes.insert(bytes.end(), below(9), static_cast<std::uint8_t>(random_()));
        return;
      case 3:  // what may be a length: huge, or a little wrong
        if (at + 4 <= bytes.size()) {
          constexpr std::uint32_t kLengths[] = {0xFFFFFFFF, 0x80000000, 0x7FFFFFFF, 0x20000000, 0x00FFFFFF,
                                                0,          1,          7,          1000};
          const std::uint32_t length = kLengths[below(std::size(kLengths))];
          std::memcpy(bytes.data() + at / 4 * 4, &length, 4);
        }
        return;
      case 4:
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at / 4 * 4),
                    bytes.end() - static_cast<std::ptrdiff_t>(
                                      std::min(bytes.size() - at / 4 * 4, below(bytes.size() + 1))));
        return;
      default:
        for (std::uint8_t& byte : bytes) {
          if (below(16) == 0) byte = static_cast<std::uint8_t>(random_());
        }
    }
  }

  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

  std::mt19937_64 random_;
};

TEST(Fuzz, HundredThousandMutatedPayloadsOfEveryType) {
  constexpr int kRounds = 100000;
  constexpr std::uint64_t kSeed = 4711;
  for (const auto& prototype : every_message()) {
    const TypeDescription& type = prototype->type();
    RandomPayload payload(kSeed, 3);
    Mutator mutate(kSeed);
    std::vector<std::uint8_t> original;
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint8_t> again;
    std::string reason;
    int accepted = 0;
    for (int round = 0; round < kRounds; ++round) {
      if (round % 50 == 0) original = payload(type);
      bytes = original;
      mutate(bytes);
      const auto message = prototype->fresh();
      largest_allocation = 0;
      bool ok = false;
      ASSERT_NO_THROW(ok = message->read(bytes, &reason))
          << type.ros_name << ", seed " << kSeed << ", round " << round;
      // A null string costs 4 bytes on the wire and 32 in memory, the worst ratio; the reason is short.
      ASSERT_LE(largest_allocation, 16 * bytes.size() + 512)
          << type.ros_name << ", seed " << kSeed << ", round " << round;
      if (!ok) continue;
      ++accepted;
      // What was accepted is a message like any other, and can be shown.
      if (round % 20 == 0) {
        ASSERT_FALSE(to_yaml(type, bytes).starts_with('#'));
      }
      message->write(again);
      ASSERT_TRUE(prototype->fresh()->read(again, nullptr))
          << type.ros_name << ", seed " << kSeed << ", round " << round;
    }
    EXPECT_GT(accepted, 0) << type.ros_name;
    EXPECT_LT(accepted, kRounds) << type.ros_name;
  }
}

}  // namespace
}  // namespace bw::test
