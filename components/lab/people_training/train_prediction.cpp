// Trains the learned prediction of people on drawn crowds, and judges it on recordings, which it never sees before:
//   train_people_prediction config/people/learned_head.txt eth.csv hotel.csv ...
// or judges weights that are there: --judge FILE eth.csv ...
// The same program gives the same bytes.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include "components/lab/people_training/prediction_fit.hpp"
#include "components/lab/people_training/prediction_judge.hpp"
#include "components/people/files/head_file.hpp"
#include "components/world/files/track_file.hpp"

namespace bw::people {
namespace {

constexpr int kCrowds = 300;
constexpr std::uint64_t kTraining = 100'000;
constexpr std::uint64_t kJudging = 200'000;

void print(const std::string& name, double noise, const char* model, const PredictionVerdict& v) {
  std::printf("%-18s %4.2f %-18s", name.c_str(), noise, model);
  for (const double loss : v.loss) std::printf(" %6.3f", loss);
  std::printf(" |");
  for (const double error : v.error) std::printf(" %.3f", error);
  std::printf(" |");
  for (const double inside : v.inside) std::printf(" %.3f", inside);
  std::printf(" | %d %d\n", v.count[0], v.count[3]);
}

void judge(const HeadWeights& head, const std::string& file) {
  const std::vector<Track> tracks = read_tracks(file);
  const std::string name = file.substr(file.find_last_of('/') + 1);
  for (const double noise : {0.0, 0.03}) {
    print(name, noise, "constant_velocity", judge_prediction(tracks, noise, {}, std::nullopt));
    PredictionOptions learned;
    learned.model = PredictionModel::learned;
    print(name, noise, "learned", judge_prediction(tracks, noise, learned, head));
  }
}

HeadWeights train(const std::string& file) {
  const std::vector<WalkSample> samples = walk_samples(kTraining, kCrowds);
  std::printf("%zu samples of %d crowds\n", samples.size(), kCrowds);
  std::ofstream out(file);
  write_head(out, fit_head(samples, {}));
  out.close();
  if (!out.good()) throw std::runtime_error(file + " cannot be written");
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
