// What an experiment must show, and the one way in which every report tells it: as text, as JSON, and as HTML
// (page_parts.hpp).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace bw {

struct Criterion {
  std::string name;
  std::string asked;  ///< such as "<= 0.04"
  double measured = 0.0;
  bool met = false;
};

bool all_met(const std::vector<Criterion>& criteria);

/// One line each: "NOT MET (a) encoder / all: 80.0000, asked > 100".
std::string criteria_text(const std::vector<Criterion>& criteria);

/// [{name, asked, measured, met}]; measured is null where it is not finite.
nlohmann::ordered_json criteria_json(const std::vector<Criterion>& criteria);

}  // namespace bw
