// What E3 and E4 must show (protocols.md 8.3, 8.4).
#pragma once

#include <vector>

#include "components/lab/experiments/edwa_experiment.hpp"

namespace bw {

/// `rows` of all scenes and pairings. A mean without a successful run meets nothing.
std::vector<Criterion> edwa_criteria(const std::vector<EdwaRow>& rows);

}  // namespace bw
