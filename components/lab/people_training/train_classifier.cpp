// Trains the table of classifier.cpp, and reports how good it is:
//   train_people_classifier components/people/detector/classifier_table.inc
//   components/people/detector/classifier_report.txt
// Rooms of other seeds judge than train. The same program gives the same bytes.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include "components/lab/people_training/boosting.hpp"
#include "components/lab/people_training/report.hpp"
#include "components/lab/people_training/table_writer.hpp"

namespace bw::people {
namespace {

constexpr Collection kTraining{.first_seed = 100'000, .rooms = 600};
constexpr Collection kJudging{.first_seed = 200'000, .rooms = 150};

FeatureRows rows_of(const std::vector<Sample>& samples) {
  FeatureRows rows{.features = kFeatures};
  for (const Sample& sample : samples)
    rows.values.insert(rows.values.end(), sample.features.values.begin(), sample.features.values.end());
  return rows;
}

double human_share(const std::vector<Sample>& samples) {
  const auto others = std::ranges::count(samples, Kind::other, &Sample::kind);
  return 1.0 - static_cast<double>(others) / static_cast<double>(samples.size());
}

std::string report(const BoostedTrees& leg, const BoostedTrees& body, double human,
                   const std::vector<Sample>& samples) {
  std::vector<HumanScores> scores;
  for (const Sample& sample : samples)
    scores.push_back(at_even_odds({probability(leg.trees, leg.bias, sample.features),
                                   probability(body.trees, body.bias, sample.features)},
                                  human));
  return report_of(samples, scores);
}

int train(const char* table, const char* report_file) {
  const std::vector<Sample> training = collect(kTraining);
  const std::vector<Sample> judging = collect(kJudging);
  const FeatureRows features = rows_of(training);
  const BoostedTrees leg = boost(features, is(Kind::leg, training), {.trees = 120});
  const BoostedTrees body = boost(features, is(Kind::body, training), {});
  const double human = human_share(training);

  std::ofstream text(report_file);
  text << "Written by components/lab/people_training/train_classifier.cpp; not by hand.\n"
       << training.size() << " outlines of " << kTraining.rooms << " rooms trained, " << judging.size()
       << " of " << kJudging.rooms << " other rooms judged.\n\n"
       << report(leg, body, human, judging);
  std::ofstream out(table);
  out << "// Written by components/lab/people_training/train_classifier.cpp; not by hand.\n// clang-format off\n";
  char share[32];
  std::snprintf(share, sizeof share, "%.5g", human);
  out << "constexpr double kHumanShare = " << share << ";\n";
  write_trees(out, "Leg", leg);
  write_trees(out, "Body", body);
  return out.good() && text.good() ? 0 : 1;
}

}  // namespace
}  // namespace bw::people

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "train_people_classifier <table to write> <report to write>\n";
    return 1;
  }
  return bw::people::train(argv[1], argv[2]);
}
