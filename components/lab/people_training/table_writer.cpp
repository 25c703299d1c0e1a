#include "components/lab/people_training/table_writer.hpp"

#include <cstdio>
#include <ostream>

namespace bw::people {
namespace {

template <std::size_t N>
std::string list(const std::array<float, N>& values) {
  std::string text = "{";
  for (std::size_t i = 0; i < N; ++i)
    text += (i > 0 ? "," : "") + literal(static_cast<double>(values[i])) + "F";
  return text + "}";
}

}  // namespace

std::string literal(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.5g", value);
  const std::string text = number;
  return text.find_first_of(".e") == std::string::npos ? text + "." : text;
}

void write_trees(std::ostream& out, const std::string& name, const BoostedTrees& boosted) {
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

}  // namespace bw::people
