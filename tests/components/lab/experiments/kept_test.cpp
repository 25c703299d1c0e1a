// Finished pieces of long work.
#include "components/lab/shards/kept.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "components/lab/experiments/kept_crossing.hpp"
#include "tests/folder.hpp"

namespace bw {
namespace {

TEST(Kept, IsFoundByTheNameAndWhatItDependsOn) {
  const test::Folder folder;
  const Kept kept(folder / "kept");
  EXPECT_FALSE(kept.find("a", "seed 1"));
  kept.put("a", "seed 1", {{"time", 0.1}});
  ASSERT_TRUE(kept.find("a", "seed 1"));
  EXPECT_EQ((*kept.find("a", "seed 1"))["time"], 0.1);
  EXPECT_FALSE(kept.find("a", "seed 2"));
  EXPECT_FALSE(kept.find("b", "seed 1"));
  kept.put("a", "seed 2", 7);  // takes its place
  EXPECT_FALSE(kept.find("a", "seed 1"));
  EXPECT_EQ(kept.find("a", "seed 2"), nlohmann::json(7));
}

TEST(Kept, AFileThatCannotBeReadCountsAsNone) {
  const test::Folder folder;
  const Kept kept(folder / "kept");
  for (const char* content : {"", "{\"made_by\": ", "[]", "{}", "{\"value\": 1}", "\xff\xfe"}) {
    std::filesystem::create_directories(folder / "kept");
    std::ofstream(folder / "kept/a.json") << content;
    EXPECT_FALSE(kept.find("a", "")) << content;
  }
}

TEST(Kept, NamesOfFilesAreOfLettersAndDigits) {
  EXPECT_EQ(file_name_of("../eteb, published seed 3"), "___eteb__published_seed_3");
}

TEST(KeptCrossing, HasTheRunsOfTheFirstTime) {
  const test::Folder folder;
  const Kept kept(folder / "kept");
  const CrossingEntry entry{"hrvo", "hrvo", {}};
  const CrossingResult driven = run_crossing(entry, {}, 2);
  const CrossingResult first = kept_crossing(kept, "a", "program", entry, {}, 2);
  const auto written = std::filesystem::last_write_time(folder / "kept/a.json");
  const CrossingResult again = kept_crossing(kept, "a", "program", entry, {}, 2);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "kept/a.json"), written);  // not made twice
  for (const CrossingResult* result : {&first, &again}) {
    ASSERT_EQ(result->runs.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const CrossingRun& run = result->runs[i];
      const CrossingRun& expected = driven.runs[i];
      EXPECT_EQ(run.seed, expected.seed);
      EXPECT_EQ(run.passing_a, expected.passing_a);
      EXPECT_EQ(run.passing_b, expected.passing_b);
      EXPECT_EQ(run.episode.success, expected.episode.success);
      EXPECT_EQ(run.episode.time, expected.episode.time);
      EXPECT_EQ(run.episode.min_clearance, expected.episode.min_clearance);
      EXPECT_EQ(run.episode.max_collision_index, expected.episode.max_collision_index);
      EXPECT_EQ(run.episode.rms_jerk, expected.episode.rms_jerk);
      ASSERT_EQ(run.path.size(), expected.path.size());
      EXPECT_EQ(run.path.back().position, expected.path.back().position);
    }
  }
  // One run more, another planner or another program is other work.
  EXPECT_EQ(kept_crossing(kept, "a", "program", entry, {}, 3).runs.size(), 3U);
  EXPECT_FALSE(kept.find("a", "program"));
}

}  // namespace
}  // namespace bw
