#include "components/tools/experiments/criterion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bw {

bool all_met(const std::vector<Criterion>& criteria) {
  return std::all_of(criteria.begin(), criteria.end(), [](const Criterion& c) { return c.met; });
}

std::string criteria_text(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& c : criteria)
    text +=
        fmt::format("{:7} {}: {:.4f}, asked {}\n", c.met ? "met" : "NOT MET", c.name, c.measured, c.asked);
  return text;
}

nlohmann::ordered_json criteria_json(const std::vector<Criterion>& criteria) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Criterion& c : criteria)
    list.push_back({{"name", c.name},
                    {"asked", c.asked},
                    {"measured", std::isfinite(c.measured) ? Json(c.measured) : Json(nullptr)},
                    {"met", c.met}});
  return list;
}

}  // namespace bw
