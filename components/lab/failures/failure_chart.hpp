// How a drive failed, seen from above: the seconds before the contact, in which way everybody went, until
// when the contact could have been avoided, and the motion that a search found from there (possible/theory.md
// 8.10).
#pragma once

#include <optional>
#include <string>

#include "components/evaluation/judged_contact.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/lab/report/chart.hpp"

namespace bw {

/// `contact`: the one that is shown; without one (a drive that was late) the whole drive and its goals. Times
/// in it are seconds since the drive began. `recording` needs a moment.
report::Chart failure_chart(const RunRecording& recording, const std::optional<JudgedContact>& contact);

}  // namespace bw
