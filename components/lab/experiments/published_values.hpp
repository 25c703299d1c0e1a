// What the source prints of each experiment, beside what is measured.
#pragma once

#include <vector>

#include "components/lab/experiments/anticipation_report.hpp"
#include "components/lab/experiments/edwa_report.hpp"
#include "components/lab/experiments/ekf_report.hpp"
#include "components/lab/experiments/pf_experiment.hpp"
#include "components/lab/experiments/published_value.hpp"

namespace bw {

/// Figure 2.3. Beside the filter "placed" the one that knows its wheels; beside the variance the mean square
/// that the word says.
std::vector<PublishedValue> published_values(const EkfReport& report);

/// Table 2.1. Beside Gaussian weights the printed ones; beside the last fix wheels alone.
std::vector<PublishedValue> published_values(const PfTable& table);

/// Table 3.2, runs that reached the goal. Beside the reading that is judged all that were run.
std::vector<PublishedValue> published_values(const std::vector<EdwaResult>& results);

/// Figures 3.7 to 3.9, 3.11 and 3.12, which print no numbers. Beside the planners' defaults their published
/// forms.
std::vector<PublishedValue> published_values(const AnticipationResults& results);

}  // namespace bw
