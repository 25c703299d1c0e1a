#include "components/lab/leaderboard/gate.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace bw {
namespace {

// 100 episodes of which the first `failed` fail.
GateRecord record(int failed) {
  GateRecord all;
  for (int k = 0; k < 100; ++k) all["s"]["p"][std::to_string(k)] = k >= failed;
  return all;
}

// Seven lost and none won: p = 2 / 128 = 0.016 holds; eight: 2 / 256 = 0.008 fails. Eight won never fail.
TEST(Gate, FailsWhereMoreAreLostThanChanceTells) {
  const auto seven = compare(record(0), record(7));
  ASSERT_EQ(seven.size(), 1U);
  EXPECT_EQ(seven[0].lost, 7);
  EXPECT_NEAR(seven[0].p, 2.0 / 128.0, 1e-12);
  EXPECT_FALSE(seven[0].failed);
  EXPECT_NEAR(compare(record(0), record(8))[0].p, 2.0 / 256.0, 1e-12);
  EXPECT_TRUE(compare(record(0), record(8))[0].failed);
  EXPECT_FALSE(compare(record(8), record(0))[0].failed);
}

TEST(Gate, ComparesWhatIsInBoth) {
  GateRecord part;
  for (int k = 0; k < 10; ++k) part["s"]["p"][std::to_string(k)] = true;
  part["other"]["p"]["1"] = false;
  const auto rows = compare(record(2), part);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].pairs, 10);
  EXPECT_EQ(rows[0].won, 2);
  EXPECT_THROW(compare(record(2), {{"other", {{"p", {{"1", true}}}}}}), std::runtime_error);
}

TEST(Gate, IsTheSameFromItsFile) {
  const auto file = std::filesystem::path(testing::TempDir()) / "bandwagon_gate.json";
  std::ofstream(file) << to_text(record(3));
  EXPECT_EQ(read_gate(file), record(3));
  std::ofstream(file) << "{\"s\": {\"p\": {}}}";
  EXPECT_THROW(read_gate(file), std::runtime_error);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace bw
