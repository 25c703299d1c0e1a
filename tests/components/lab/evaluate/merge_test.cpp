// Shards of an evaluation as one: order, and what is refused.
#include "components/lab/evaluate/merge.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using testing::HasSubstr;

// Two suites, of three and of two drives; drive k has seed k.
ResultsFile shard(std::int64_t number, std::int64_t of) {
  ResultsFile file{.file = std::to_string(number) + ".json",
                   .made = {"build", "revision", "cpu", "drives", number, of},
                   .planned = 0,
                   .results = {{"a", {}}, {"b", {}}}};
  for (std::int64_t k = number - 1; k < 5; k += of) {
    file.results[k < 3 ? 0 : 1].episodes.push_back({"e", k, "p", {}});
    ++file.planned;
  }
  return file;
}

std::vector<std::int64_t> seeds_of(const std::vector<SuiteResult>& results) {
  std::vector<std::int64_t> seeds;
  for (const SuiteResult& result : results)
    for (const EpisodeResult& episode : result.episodes) seeds.push_back(episode.seed);
  return seeds;
}

std::string refusal(const std::vector<ResultsFile>& shards) {
  try {
    merge(shards);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(Merge, HasTheDrivesInTheOrderOfOneRun) {
  for (std::int64_t of = 1; of <= 5; ++of) {
    std::vector<ResultsFile> shards;
    for (std::int64_t number = of; number >= 1; --number) shards.push_back(shard(number, of));
    const std::vector<SuiteResult> merged = merge(shards);
    ASSERT_EQ(merged.size(), 2U);
    EXPECT_EQ(merged[0].suite, "a");
    EXPECT_EQ(seeds_of(merged), (std::vector<std::int64_t>{0, 1, 2, 3, 4})) << of;
  }
}

TEST(Merge, RefusesWhatIsNotOneEvaluation) {
  EXPECT_EQ(refusal({shard(1, 2), shard(2, 2)}), "none");
  EXPECT_THAT(refusal({shard(1, 2)}), HasSubstr("shard 2/2 is missing"));
  EXPECT_THAT(refusal({shard(1, 2), shard(1, 2)}), HasSubstr("are both shard 1"));
  EXPECT_THAT(refusal({shard(1, 2), shard(2, 3)}), HasSubstr("number of shards: 2, and 3"));
  ResultsFile other = shard(2, 2);
  other.made.revision = "another";
  EXPECT_THAT(refusal({shard(1, 2), other}), HasSubstr("1.json and 2.json do not go together; revision"));
  other = shard(2, 2);
  other.made.cpu = "another";
  EXPECT_THAT(refusal({shard(1, 2), other}), HasSubstr("processor: cpu, and another"));
  other = shard(2, 2);
  other.made.drives = "others";
  EXPECT_THAT(refusal({shard(1, 2), other}), HasSubstr("what is driven"));
  other = shard(2, 2);
  other.planned = 3;
  EXPECT_THAT(refusal({shard(1, 2), other}), HasSubstr("2.json is not complete: 2 of 3 drives"));
}

TEST(ResultsFile, ThatIsCutIsRefusedByName) {
  const auto file = std::filesystem::path(testing::TempDir()) / "bandwagon_cut.json";
  std::ofstream(file) << R"({"suite": "a", "episodes": [{"na)";
  try {
    read_results_file(file);
    ADD_FAILURE() << "read";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("bandwagon_cut.json: holds no drives of `evaluate --json`"));
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace bw
