// What a reader of an experiment must know before believing it: what was chosen with the published values in
// view, and what the exit status stands for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "components/lab/experiments/criterion.hpp"

namespace bw {

/// Of the subject of `bandwagon reproduce`, one sentence each; empty: nothing was. Throws std::out_of_range
/// for a subject that is not known.
const std::vector<std::string>& tuned_to_published(std::string_view subject);

/// "what: met", "what: NOT MET (2 of 7 criteria)", "what: not judged (too few seeds)" or "what: met (2 of 7
/// criteria; 5 not judged: too few seeds)".
std::string verdict(std::string_view what, const std::vector<Criterion>& criteria);

/// The last lines of every experiment: what was tuned, what is judged. Each line ends.
std::string closing_lines(std::string_view subject, std::string_view judged_what,
                          const std::vector<Criterion>& judged);

}  // namespace bw
