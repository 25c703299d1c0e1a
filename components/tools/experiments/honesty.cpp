#include "components/tools/experiments/honesty.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace bw {
namespace {

const std::map<std::string, std::vector<std::string>>& tuned() {
  static const std::map<std::string, std::vector<std::string>> kTuned = {
      {"ekf",
       {"ways, rates and noises of the simulated drives, which are not published",
        "the wheel noise of the rows \"placed\" (k_f = 0.03 m), which puts the fused errors where they were published"}},
      {"pf",
       {"length of the run, radius of the circle and times of the roof, which are not published; about twenty "
        "variants were tried",
        "the units of the printed step noise (cm and degrees)"}},
      {"edwa",
       {"places of the robots in the four scenes, which are published as a picture",
        "the robots' margins and the options of DWA and EDWA in the published setting"}},
      {"pteb",
       {"the places of the crossing people: 1 m farther away than first proposed, for at those no planner passes in "
        "front of anybody"}},
      {"eteb",
       {"the places of the crossing people: 1 m farther away than first proposed, for at those no planner passes in "
        "front of anybody"}},
  };
  return kTuned;
}

}  // namespace

const std::vector<std::string>& tuned_to_published(std::string_view subject) {
  return tuned().at(std::string(subject));
}

std::string verdict(std::string_view what, const std::vector<Criterion>& criteria) {
  const auto missed =
      std::count_if(criteria.begin(), criteria.end(), [](const Criterion& c) { return !c.met; });
  if (missed == 0) return fmt::format("{}: met", what);
  return fmt::format("{}: NOT MET ({} of {} criteria)", what, missed, criteria.size());
}

std::string closing_lines(std::string_view subject, std::string_view judged_what,
                          const std::vector<Criterion>& judged) {
  std::string text;
  for (const std::string& what : tuned_to_published(subject))
    text += fmt::format("tuned to the published values: {}\n", what);
  return text + fmt::format("judged by the exit status: {}\n", verdict(judged_what, judged));
}

}  // namespace bw
