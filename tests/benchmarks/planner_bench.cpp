// Runs the planner benches while tuning:
//   planner_bench teb|crowd SCENES [--scene NAME] [--repetitions N] [--weights file|default] [--json FILE]
//   [path.to.option=value ...]
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "components/local_planner/bench/bench.hpp"

namespace {

// Sets the options named in `values` by their dotted path, through the field list.
class OptionSetter {
 public:
  explicit OptionSetter(std::map<std::string, std::string>& values) : values_(values) {}

  template <class T>
  void operator()(const char* name, T& field, const bw::Field&) {
    const std::string path = prefix_ + name;
    if constexpr (std::is_class_v<T>) {
      const std::string outer = prefix_;
      prefix_ = path + ".";
      field.fields(*this);
      prefix_ = outer;
    } else {
      const auto found = values_.find(path);
      if (found == values_.end()) return;
      field = static_cast<T>(std::stod(found->second));
      values_.erase(found);
    }
  }

 private:
  std::map<std::string, std::string>& values_;
  std::string prefix_;
};

int run(int argc, char** argv) {
  if (argc < 3) throw std::runtime_error("usage: planner_bench teb|crowd SCENES [options]");
  std::map<std::string, std::string> flags;
  std::map<std::string, std::string> values;
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--") && i + 1 < argc) {
      flags[word.substr(2)] = argv[++i];
    } else if (const auto equal = word.find('='); equal != std::string::npos) {
      values[word.substr(0, equal)] = word.substr(equal + 1);
    } else {
      throw std::runtime_error("not understood: " + word);
    }
  }
  bw::LocalPlannerOptions options;
  OptionSetter setter(values);
  options.fields(setter);
  if (!values.empty()) throw std::runtime_error("unknown option " + values.begin()->first);
  const std::string planner = flags.contains("planner") ? flags["planner"] : "teb";
  if (std::strcmp(argv[1], "teb") == 0) {
    bw::BenchTebArguments arguments;
    arguments.scenes = argv[2];
    arguments.scene = flags["scene"];
    arguments.planner = planner;
    arguments.options = options;
    arguments.json = flags["json"];
    if (flags.contains("repetitions")) arguments.repetitions = std::stoi(flags["repetitions"]);
    if (flags.contains("weights")) {
      arguments.weights = {flags["weights"] == "file" ? bw::BenchWeights::file : bw::BenchWeights::defaults};
    }
    return bw::bench_teb(arguments);
  }
  bw::BenchCrowdArguments arguments;
  arguments.scenes = argv[2];
  arguments.scene = flags["scene"];
  arguments.planner = planner;
  arguments.options = options;
  arguments.json = flags["json"];
  if (flags["weights"] == "file") arguments.weights = bw::BenchWeights::file;
  return bw::bench_crowd(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
