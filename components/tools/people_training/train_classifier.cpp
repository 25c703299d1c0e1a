// Trains the table of classifier.cpp and says how good it is:
//   train_people_classifier components/people/detector/classifier_table.inc
// Rooms of other seeds judge than train. The same program gives the same table.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include "components/tools/people_training/boosting.hpp"
#include "components/tools/people_training/figures.hpp"
#include "components/tools/people_training/samples.hpp"

namespace bw::people {
namespace {

constexpr Collection kTraining{.first_seed = 100'000, .rooms = 400, .sweeps = 120, .every = 4};
constexpr Collection kJudging{.first_seed = 200'000, .rooms = 100, .sweeps = 120, .every = 4};

std::vector<Features> features_of_all(const std::vector<Sample>& samples) {
  std::vector<Features> features;
  for (const Sample& sample : samples) features.push_back(sample.features);
  return features;
}

std::vector<std::uint8_t> is(Kind kind, const std::vector<Sample>& samples) {
  std::vector<std::uint8_t> flags;
  for (const Sample& sample : samples) flags.push_back(sample.kind == kind);
  return flags;
}

template <std::size_t N>
std::string list(const std::array<float, N>& values) {
  std::string text = "{";
  for (std::size_t i = 0; i < N; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%.5g", static_cast<double>(values[i]));
    std::string literal = number;
    if (literal.find_first_of(".e") == std::string::npos) literal += ".";
    text += (i > 0 ? "," : "") + literal + "F";
  }
  return text + "}";
}

void write(std::ostream& out, const std::string& name, const BoostedTrees& boosted) {
  char bias[32];
  std::snprintf(bias, sizeof bias, "%.5g", static_cast<double>(boosted.bias));
  out << "constexpr float k" << name << "Bias = static_cast<float>(" << bias << ");\n";
  out << "constexpr std::array<DecisionTree, " << boosted.trees.size() << "> k" << name << "Trees = {{\n";
  for (const DecisionTree& tree : boosted.trees) {
    out << "{{";
    for (std::size_t i = 0; i < tree.feature.size(); ++i) out << (i > 0 ? "," : "") << int{tree.feature[i]};
    out << "}," << list(tree.threshold) << "," << list(tree.leaf) << "},\n";
  }
  out << "}};\n";
}

std::string judged(const std::string& name, const BoostedTrees& boosted, Kind kind,
                   const std::vector<Sample>& samples) {
  std::vector<double> scores;
  for (const Sample& sample : samples)
    scores.push_back(probability(boosted.trees, boosted.bias, sample.features));
  const ClassifierFigures f = figures_of(scores, is(kind, samples));
  char text[200];
  std::snprintf(text, sizeof text, "%s: ROC area %.4f, precision %.3f and recall %.3f at 0.5 (%d of %d)",
                name.c_str(), f.area, f.precision, f.recall, f.positives, f.positives + f.negatives);
  return text;
}

int train(const char* path) {
  const std::vector<Sample> training = collect(kTraining);
  const std::vector<Sample> judging = collect(kJudging);
  const std::vector<Features> features = features_of_all(training);
  const BoostedTrees leg = boost(features, is(Kind::leg, training), {.trees = 120});
  const BoostedTrees body = boost(features, is(Kind::body, training), {});
  const std::string leg_text = judged("leg", leg, Kind::leg, judging);
  const std::string body_text = judged("body", body, Kind::body, judging);
  std::cout << training.size() << " outlines trained, " << judging.size() << " judged\n"
            << "on training rooms  " << judged("leg", leg, Kind::leg, training) << "\n"
            << "on training rooms  " << judged("body", body, Kind::body, training) << "\n"
            << leg_text << "\n"
            << body_text << "\n";
  std::ofstream out(path);
  out << "// Written by training/train_classifier.cpp; not by hand. On rooms that were not trained on:\n"
      << "//   " << leg_text << "\n//   " << body_text << "\n// clang-format off\n";
  write(out, "Leg", leg);
  write(out, "Body", body);
  return out.good() ? 0 : 1;
}

}  // namespace
}  // namespace bw::people

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "train_people_classifier <file to write>\n";
    return 1;
  }
  return bw::people::train(argv[1]);
}
