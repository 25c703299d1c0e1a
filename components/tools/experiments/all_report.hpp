// What `bandwagon reproduce all` makes of the results of its parts: one list of verdicts, one page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/tools/experiments/criterion.hpp"

namespace bw {

/// A subject of `bandwagon reproduce` as a part of all of them.
struct AllPart {
  std::string subject;          ///< its folder beside the page
  std::string experiments;      ///< "E1, E7"
  std::string what;             ///< "the EKF: Figure 2.3, and logs of real robots"
  nlohmann::json results = {};  ///< its results.json; null: there is none
  std::string trouble = {};     ///< why there is none
};

/// Those of `reproduce all`, in the order of the source; PTEB is a part of `eteb`.
std::vector<AllPart> all_parts();

enum class Verdict {
  reproduced,      ///< all criteria are judged and met
  not_reproduced,  ///< some are not met
  in_part,         ///< some are met, others need more seeds
  not_judged,      ///< all need more seeds
  missing          ///< it did not come to an end
};
std::string_view to_string(Verdict verdict);

std::vector<Criterion> criteria_of(const AllPart& part);
Verdict verdict_of(const AllPart& part);

/// Every part came to an end, and what it judges is met.
bool all_reproduced(const std::vector<AllPart>& parts);

struct AllRun {
  std::vector<AllPart> parts;
  bool quick = false;
  bool is_finished = false;  ///< otherwise the page says that it goes on
  std::string program = {};  ///< version and revision
};

/// {experiment: "all", quick, finished, reproduced, parts: [{subject, experiments, verdict, judged, criteria, other_readings, published,
/// tuned_to_published, page}]}
nlohmann::ordered_json all_json(const AllRun& run);

/// One line a part, then the criteria that are missed.
std::string all_table(const std::vector<AllPart>& parts);

/// One self-contained HTML page with links to those of the parts.
std::string all_page(const AllRun& run);

}  // namespace bw
