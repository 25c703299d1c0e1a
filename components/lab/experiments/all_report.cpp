#include "components/lab/experiments/all_report.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

Criterion criterion_of(const nlohmann::json& json) {
  Criterion c{.name = json.at("name"), .asked = json.at("asked")};
  c.measured = json.at("measured").is_number() ? json["measured"].get<double>()
                                               : std::numeric_limits<double>::quiet_NaN();
  c.met = json.at("met").is_boolean() && json["met"].get<bool>();
  c.not_judged = json.value("not_judged", "");
  return c;
}

/// "6 of 8 criteria met, 2 not judged"
std::string in_numbers(const std::vector<Criterion>& criteria) {
  const auto open = std::ranges::count_if(criteria, [](const Criterion& c) { return !c.not_judged.empty(); });
  const auto met =
      std::ranges::count_if(criteria, [](const Criterion& c) { return c.not_judged.empty() && c.met; });
  return fmt::format("{} of {} criteria met{}", met, std::ssize(criteria) - open,
                     open == 0 ? "" : fmt::format(", {} not judged", open));
}

}  // namespace

std::vector<AllPart> all_parts() {
  return {
      {"ekf", "E1, E7", "EKF: Figure 2.3, and logs of real robots"},
      {"pf", "E2", "Particle filter: Table 2.1"},
      {"edwa", "E3, E4", "EDWA: Table 3.2, Figure 3.4"},
      {"eteb", "E5, E6", "PTEB and ETEB: Figures 3.7 to 3.9, 3.11, 3.12"},
      {"navigation", "Robots", "The whole system on Eddie and QBot 2e: Figure 3.5, section 3.4"},
  };
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::not_reproduced:
      return "not reproduced";
    case Verdict::in_part:
      return "what few seeds show is met";
    case Verdict::not_judged:
      return "not judged: too few seeds";
    case Verdict::missing:
      return "no result";
  }
  return "unknown";
}

std::vector<Criterion> criteria_of(const AllPart& part) {
  std::vector<Criterion> criteria;
  if (!part.results.is_object()) return criteria;
  for (const nlohmann::json& json : part.results.at("criteria")) criteria.push_back(criterion_of(json));
  return criteria;
}

Verdict verdict_of(const AllPart& part) {
  if (!part.results.is_object()) return Verdict::missing;
  const std::vector<Criterion> criteria = criteria_of(part);
  if (criteria.empty()) return Verdict::not_judged;
  if (!all_met(criteria)) return Verdict::not_reproduced;
  const auto open = std::ranges::count_if(criteria, [](const Criterion& c) { return !c.not_judged.empty(); });
  if (open == 0) return Verdict::reproduced;
  return open == std::ssize(criteria) ? Verdict::not_judged : Verdict::in_part;
}

bool nothing_missed(const std::vector<AllPart>& parts) {
  return std::ranges::none_of(parts, [](const AllPart& part) {
    const Verdict verdict = verdict_of(part);
    return verdict == Verdict::missing || verdict == Verdict::not_reproduced;
  });
}

bool is_reproduced(const AllRun& run) {
  return run.is_finished && !run.parts.empty() && std::ranges::all_of(run.parts, [](const AllPart& part) {
           return verdict_of(part) == Verdict::reproduced;
         });
}

nlohmann::ordered_json all_json(const AllRun& run) {
  Json parts = Json::array();
  Json verdicts = Json::object();
  for (const Verdict verdict : kAllVerdicts)
    verdicts[std::string(to_string(verdict))] = std::ranges::count(run.parts, verdict, verdict_of);
  for (const AllPart& part : run.parts) {
    Json json = {{"subject", part.subject},
                 {"experiments", part.experiments},
                 {"verdict", to_string(verdict_of(part))}};
    if (part.results.is_object()) {
      for (const char* key : {"judged", "criteria", "other_readings", "published", "tuned_to_published"})
        json[key] = part.results.at(key);
      json["page"] = part.subject + "/index.html";
    } else {
      json["trouble"] = part.trouble;
    }
    parts.push_back(std::move(json));
  }
  return {{"experiment", "all"},
          {"quick", run.quick},
          {"finished", run.is_finished},
          {"reproduced", is_reproduced(run)},
          {"nothing_missed", run.is_finished && nothing_missed(run.parts)},
          {"verdicts", std::move(verdicts)},
          {"parts", std::move(parts)}};
}

std::string all_table(const std::vector<AllPart>& parts) {
  std::string out, missed;
  for (const AllPart& part : parts) {
    const std::vector<Criterion> criteria = criteria_of(part);
    out += fmt::format("{:<8} {:<66} {:<28} {}\n", part.experiments, part.what, to_string(verdict_of(part)),
                       part.results.is_object() ? in_numbers(criteria) : part.trouble);
    for (const Criterion& c : criteria)
      if (c.not_judged.empty() && !c.met)
        missed +=
            fmt::format("not met  {}: {}: {:.4g}, asked {}\n", part.experiments, c.name, c.measured, c.asked);
  }
  return out + missed;
}

}  // namespace bw
