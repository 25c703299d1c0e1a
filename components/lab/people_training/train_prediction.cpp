// Trains the learned prediction of people on drawn crowds, and judges it on recordings, which it never sees before:
//   train_people_prediction config/people/learned_head.txt eth.csv hotel.csv ...
// or judges weights that are there: --judge FILE eth.csv ...
// The same program gives the same bytes.
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

#include "components/lab/people_training/prediction_fit.hpp"
#include "components/lab/people_training/prediction_judge.hpp"
#include "components/people/files/head_file.hpp"
#include "components/world/files/track_file.hpp"
#include "runtime/atomic_file.hpp"

namespace bw::people {
namespace {

constexpr int kCrowds = 300;
constexpr std::uint64_t kTraining = 100'000;
constexpr std::uint64_t kJudging = 200'000;

void print(const std::string& name, double noise, const char* model,
           const std::vector<PredictionVerdict>& verdicts) {
  std::printf("%-18s %4.2f %-18s", name.c_str(), noise, model);
  for (const PredictionVerdict& v : verdicts) std::printf(" %6.3f", v.loss);
  std::printf(" |");
  for (const PredictionVerdict& v : verdicts) std::printf(" %.3f", v.error);
  std::printf(" |");
  for (const PredictionVerdict& v : verdicts) std::printf(" %.3f", v.inside);
  std::printf(" | %d %d\n", verdicts.front().count, verdicts.back().count);
}

void judge(const HeadWeights& head, const std::string& file) {
  const std::vector<Track> tracks = read_tracks(file);
  const std::string name = file.substr(file.find_last_of('/') + 1);
  for (const double noise : {0.0, 0.03}) {
    const Judging how{.noise = noise};
    print(name, noise, "constant_velocity", judge_prediction(tracks, Predictor({}), how));
    print(name, noise, "learned", judge_prediction(tracks, Predictor({}, head), how));
  }
}

HeadWeights train(const std::string& file) {
  const std::vector<WalkSample> samples = walk_samples(kTraining, kCrowds);
  std::printf("%zu samples of %d crowds\n", samples.size(), kCrowds);
  std::ostringstream text;
  write_head(text, fit_head(samples, {}));
  write_file_atomically(file, text.str());
  HeadWeights head = read_head(file);  // what is used later: five digits
  std::printf("drawn crowds, 0.5 to 4 s:");
  for (const double loss : losses(head, walk_samples(kJudging, kCrowds / 8))) std::printf(" %.3f", loss);
  std::printf("\n");
  return head;
}

int run(int argc, char** argv) {
  const bool only_judges = std::string(argv[1]) == "--judge";
  const int file = only_judges ? 2 : 1;
  const HeadWeights head = only_judges ? read_head(argv[file]) : train(argv[file]);
  for (int i = file + 1; i < argc; ++i) judge(head, argv[i]);
  return 0;
}

}  // namespace
}  // namespace bw::people

int main(int argc, char** argv) {
  if (argc < 2 || (std::string(argv[1]) == "--judge" && argc < 3)) {
    std::cerr << "train_people_prediction [--judge] <weights> <recorded tracks>...\n";
    return 1;
  }
  try {
    return bw::people::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
