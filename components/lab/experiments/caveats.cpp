#include "components/lab/experiments/caveats.hpp"

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
      {"navigation", {}},  // nothing is published
  };
  return kTuned;
}

}  // namespace

const std::vector<std::string>& tuned_to_published(std::string_view subject) {
  return tuned().at(std::string(subject));
}

std::string verdict(std::string_view what, const std::vector<Criterion>& criteria) {
  const auto count = [&](auto is_meant) { return std::ranges::count_if(criteria, is_meant); };
  const auto open = count([](const Criterion& c) { return !c.not_judged.empty(); });
  const auto missed = count([](const Criterion& c) { return c.not_judged.empty() && !c.met; });
  const auto judged = std::ssize(criteria) - open;
  const std::string rest = open == 0 ? "" : fmt::format("{} not judged", open);
  if (missed > 0)
    return fmt::format("{}: NOT MET ({} of {} criteria{})", what, missed, judged,
                       open == 0 ? "" : "; " + rest);
  if (open == 0) return fmt::format("{}: met", what);
  if (judged == 0) return fmt::format("{}: not judged (too few seeds)", what);
  return fmt::format("{}: met ({} of {} criteria; {}: too few seeds)", what, judged, std::ssize(criteria),
                     rest);
}

std::string closing_lines(std::string_view subject, std::string_view judged_what,
                          const std::vector<Criterion>& judged) {
  std::string text;
  for (const std::string& what : tuned_to_published(subject))
    text += fmt::format("tuned to the published values: {}\n", what);
  if (tuned_to_published(subject).empty()) text += "tuned to the published values: nothing\n";
  return text + fmt::format("judged by the exit status: {}\n", verdict(judged_what, judged));
}

}  // namespace bw
