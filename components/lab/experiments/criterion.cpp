#include "components/lab/experiments/criterion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bw {

Criterion over_seeds(Criterion criterion, std::size_t seeds, std::size_t needed) {
  if (seeds < needed) criterion.not_judged = fmt::format("{} of {} seeds", seeds, needed);
  return criterion;
}

bool all_met(const std::vector<Criterion>& criteria) {
  return std::all_of(criteria.begin(), criteria.end(),
                     [](const Criterion& c) { return c.met || !c.not_judged.empty(); });
}

std::string criteria_text(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& c : criteria) {
    const std::string state = c.not_judged.empty() ? fmt::format("{:7} ", c.met ? "met" : "NOT MET")
                                                   : "not judged, " + c.not_judged + ": ";
    text += fmt::format("{}{}: {:.4f}, asked {}\n", state, c.name, c.measured, c.asked);
  }
  return text;
}

nlohmann::ordered_json criteria_json(const std::vector<Criterion>& criteria) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Criterion& c : criteria) {
    list.push_back({{"name", c.name},
                    {"asked", c.asked},
                    {"measured", std::isfinite(c.measured) ? Json(c.measured) : Json(nullptr)},
                    {"met", c.not_judged.empty() ? Json(c.met) : Json(nullptr)}});
    if (!c.not_judged.empty()) list.back()["not_judged"] = c.not_judged;
  }
  return list;
}

}  // namespace bw
