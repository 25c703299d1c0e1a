// `bandwagon-lab tune`: a planner's parameters by successive halving, judged on other seeds and on another suite.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/ordered_run.hpp"
#include "components/lab/bench/planner_overrides.hpp"
#include "components/lab/comparison/paired.hpp"
#include "components/lab/shards/kept.hpp"
#include "components/lab/tune/successive_halving.hpp"
#include "components/lab/tune/tune_suite.hpp"
#include "components/lab/tune/tuned_parameters.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::tune {
namespace {

constexpr std::uint64_t kTuned = 20'001;   // first episode of those that are tuned on
constexpr std::uint64_t kJudged = 40'001;  // and of those that judge

struct Arguments {
  TuneSuite suite = TuneSuite::crowd;
  TuneSuite other = TuneSuite::corridor;
  std::string suite_name = "crowd", other_name = "corridor";
  std::string planner = "eteb";
  std::vector<std::string> parameters, set;
  int drives = 2000;
  int judged = 200;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string log = "tune";
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " --set " + word;
  return text.empty() ? " as it is" : text;
}

class Tuning {
 public:
  explicit Tuning(const Arguments& arguments)
      : arguments_(arguments),
        parameters_(parameters_of(arguments.planner, arguments.parameters, arguments.set)),
        log_(arguments.log) {}

  int run() {
    const std::size_t count = candidates_for(static_cast<std::size_t>(arguments_.drives));
    std::printf("%s on %s: %zu parameters, %zu candidates, at most %d drives, log %s\n",
                arguments_.planner.c_str(), arguments_.suite_name.c_str(), parameters_.size(), count,
                arguments_.drives, arguments_.log.c_str());
    const std::vector<Candidate> ranked =
        successive_halving(count, [&](std::size_t k, std::size_t first, std::size_t n) {
          const std::vector<TuneDrive> drives =
              drive(arguments_.suite, fmt::format("{}_{}_{}", arguments_.suite_name, k, first), settings(k),
                    kTuned + first, n);
          std::vector<double> costs;
          for (const TuneDrive& one : drives) costs.push_back(one.cost());
          std::printf("candidate %zu, %zu episodes: cost %.4f\n", k, first + n,
                      std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(n));
          std::fflush(stdout);
          return costs;
        });
    for (std::size_t k = 0; k < std::min<std::size_t>(ranked.size(), 5); ++k)
      std::printf("%zu. candidate %zu, cost %.4f in %zu episodes:%s\n", k + 1, ranked[k].number,
                  ranked[k].cost, ranked[k].episodes, joined(settings(ranked[k].number)).c_str());
    const std::size_t best = ranked.front().number;
    judge(arguments_.suite, arguments_.suite_name, best);
    judge(arguments_.other, arguments_.other_name, best);
    return 0;
  }

 private:
  std::vector<std::string> settings(std::size_t candidate) const {
    std::vector<std::string> all = arguments_.set;
    for (std::string& turned : settings_of(parameters_, candidate, arguments_.seed))
      all.push_back(std::move(turned));
    return all;
  }

  std::vector<TuneDrive> drive(TuneSuite suite, const std::string& name, const std::vector<std::string>& set,
                               std::uint64_t first, std::size_t count) {
    const std::string made_by =
        fmt::format("{} {} {} {}", arguments_.planner, build_id(), count, joined(set));
    std::vector<TuneDrive> drives;
    if (const auto known = log_.find(name, made_by)) {
      for (const nlohmann::json& one : known->at("drives"))
        drives.push_back({one.at("success"), one.at("time_s"), one.at("limit_s")});
      return drives;
    }
    PlannerOptions options;
    apply_overrides(options, set);
    const auto one = [&](std::size_t i, const CpuClock&) {
      return drive_episode(suite, first + i, arguments_.planner, options);
    };
    drives = run_in_order(count, arguments_.jobs, one);
    nlohmann::json kept = {{"set", set}, {"drives", nlohmann::json::array()}};
    for (const TuneDrive& d : drives)
      kept["drives"].push_back({{"success", d.success}, {"time_s", d.time}, {"limit_s", d.limit}});
    log_.put(name, made_by, kept);
    return drives;
  }

  std::vector<PairedEpisode> judged(TuneSuite suite, const std::string& name,
                                    const std::vector<std::string>& set) {
    std::vector<PairedEpisode> all;
    for (const TuneDrive& one : drive(suite, name, set, kJudged, static_cast<std::size_t>(arguments_.judged)))
      all.push_back({.key = std::to_string(all.size()), .success = one.success, .time = one.time});
    return all;
  }

  /// Against candidate 0, and against none of --set.
  void judge(TuneSuite suite, const std::string& suite_name, std::size_t best) {
    const auto successes = [](const std::vector<PairedEpisode>& all) {
      return std::count_if(all.begin(), all.end(), [](const PairedEpisode& e) { return e.success; });
    };
    const std::vector<PairedEpisode> after =
        judged(suite, fmt::format("{}_{}_judged", suite_name, best), settings(best));
    std::vector<std::vector<std::string>> others = {{}};
    if (!arguments_.set.empty()) others.push_back(arguments_.set);
    for (std::size_t k = 0; k < others.size(); ++k) {
      const std::vector<PairedEpisode> before =
          judged(suite, fmt::format("{}_{}_judged", suite_name, k == 0 ? "as_it_is" : "0"), others[k]);
      const Comparison c = compare(before, after);
      std::printf(
          "%s, fresh: %td of %d tuned, %td %s (McNemar p %.3g); time of both %+.2f s (%+.2f to %+.2f)\n",
          suite_name.c_str(), successes(after), arguments_.judged, successes(before),
          k == 0 ? "as it is" : "by --set", c.p, c.time.mean, c.time.low, c.time.high);
    }
  }

  const Arguments& arguments_;
  std::vector<TunedParameter> parameters_;
  Kept log_;
};

TuneSuite suite_of(const std::string& name) {
  return name == "crowdnav"   ? TuneSuite::crowdnav
         : name == "corridor" ? TuneSuite::corridor
                              : TuneSuite::crowd;
}

void add_tune(cli::Verb verb) {
  auto arguments = std::make_shared<Arguments>();
  verb.option_function(
          "--suite",
          [arguments](const std::string& name) {
            arguments->suite_name = name;
            arguments->suite = suite_of(name);
          },
          "Tuned on: crowd (default), crowdnav or corridor")
      .one_of({"crowd", "crowdnav", "corridor"});
  verb.option_function(
          "--other",
          [arguments](const std::string& name) {
            arguments->other_name = name;
            arguments->other = suite_of(name);
          },
          "Judged on as well: corridor (default), crowd or crowdnav")
      .one_of({"crowd", "crowdnav", "corridor"});
  verb.option("--planner", arguments->planner, "The planner (eteb)");
  verb.option("--parameters", arguments->parameters,
              "Names, separated by commas; default: all numbers of its section")
      .separated_by_commas();
  verb.option("--set", arguments->set,
              "Parameter where candidates begin: the first has it, others are drawn about it")
      .one_each_time();
  verb.option("--drives", arguments->drives, "Of the tuning (2000)").within(1, 10'000'000);
  verb.option("--judged", arguments->judged, "Fresh episodes of each suite that judge (200)")
      .within(1, 1'000'000);
  verb.option("--seed", arguments->seed, "Of the candidates (1)");
  verb.option("--jobs", arguments->jobs, "Drives at a time (1)").within(1, 1024);
  verb.option("--log", arguments->log, "Folder of all drives; the same command goes on with it (tune)");
  verb.run([arguments] { return Tuning(*arguments).run(); });
}

}  // namespace

BW_VERB(measure, "tune", "A planner's parameters by many drives, judged on others", add_tune)

}  // namespace bw::tune
