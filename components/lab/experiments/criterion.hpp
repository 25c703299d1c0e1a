// What an experiment must show, and the one way in which every report tells it: as text, as JSON, and in a
// document (first_screen.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace bw {

struct Criterion {
  std::string name;
  std::string asked;  ///< such as "<= 0.04"
  double measured = 0.0;
  bool met = false;
  std::string not_judged = {};  ///< why not, such as "5 of 40 seeds"; empty: it is judged
};

/// What is asked of a mean, a median or a share over seeds is not judged with fewer than `needed`: a seed
/// more or less would turn it. What must hold of every single run is judged with any number.
Criterion over_seeds(Criterion criterion, std::size_t seeds, std::size_t needed);

/// Of those that are judged.
bool all_met(const std::vector<Criterion>& criteria);

/// One line each: "NOT MET (a) encoder / all: 80.0000, asked > 100", "not judged, 5 of 40 seeds: (a) ...".
std::string criteria_text(const std::vector<Criterion>& criteria);

/// [{name, asked, measured, met}]; measured is null where it is not finite, met where it is not judged, and
/// then `not_judged` says why.
nlohmann::ordered_json criteria_json(const std::vector<Criterion>& criteria);

}  // namespace bw
