// What `bandwagon reproduce pteb|eteb` writes: E5 (people crossing) and E6 (hallway) as JSON and as a page,
// with what was published beside what is measured.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/crossing_report.hpp"
#include "components/lab/experiments/hallway_experiment.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

struct AnticipationResults {
  std::string subject;                   ///< pteb or eteb
  CrossingGeometry geometry;             ///< of `crossing`
  std::vector<CrossingResult> crossing;  ///< default and published entries
  std::vector<CrossingResult> proposed;  ///< default entries at the positions first proposed
  std::vector<HallwayDrive> hallway;
};

/// What must hold of the planners as they drive by default.
std::vector<Criterion> anticipation_criteria(const AnticipationResults& results);

/// The same asked of the planners as published.
std::vector<Criterion> published_criteria(const AnticipationResults& results);

/// {experiment, criteria, criteria_as_published, crossing, crossing_as_proposed, hallway}
nlohmann::ordered_json anticipation_json(const AnticipationResults& results);

/// What the page shows.
report::Document anticipation_page(const AnticipationResults& results);

}  // namespace bw
