// The tracks of a run as a report: from above, beside the labels of each stretch; their distance from the
// robot, and the life of each, over time.
#pragma once

#include "components/lab/bench/bench_people.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

report::Document people_page(const PeopleRun& run);

}  // namespace bw
