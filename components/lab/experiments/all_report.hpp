// What `bandwagon reproduce all` makes of the results of its parts: one list of verdicts, one page.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/report/document.hpp"

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
  not_judged,      ///< there are none, or all need more seeds
  missing          ///< it did not come to an end
};
inline constexpr std::array kAllVerdicts = {Verdict::reproduced, Verdict::not_reproduced, Verdict::in_part,
                                            Verdict::not_judged, Verdict::missing};
std::string_view to_string(Verdict verdict);

std::vector<Criterion> criteria_of(const AllPart& part);
Verdict verdict_of(const AllPart& part);

/// Every part came to an end, and what it judges is met: the exit status. A quick run judges little and may
/// miss nothing.
bool nothing_missed(const std::vector<AllPart>& parts);

struct AllRun {
  std::vector<AllPart> parts;
  bool quick = false;
  bool is_finished = false;  ///< otherwise the page says that it goes on
  std::string program = {};  ///< version and revision
};

/// Finished, and every criterion of every part is judged and met.
bool is_reproduced(const AllRun& run);

/// {experiment: "all", quick, finished, reproduced, nothing_missed, verdicts: {verdict: number of parts},
/// parts: [{subject, experiments, verdict, judged, criteria, other_readings, published, tuned_to_published,
/// page}]}
nlohmann::ordered_json all_json(const AllRun& run);

/// One line a part, then the criteria that are missed.
std::string all_table(const std::vector<AllPart>& parts);

/// What the page shows, with links to those of the parts.
report::Document all_page(const AllRun& run);

}  // namespace bw
