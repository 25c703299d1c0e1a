// Which detections of a sweep the tracker looks at.
#pragma once

#include <vector>

#include "components/people/detection.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// Fills `selected` with what is finite, has a covariance that says something and is narrow enough for a part
/// of a person, at most `most`, the least human left out; what does not look human is made as unsure as
/// options.vague says.
void select_detections(const DetectionSet& sweep, int most, const AssociationOptions& options,
                       std::vector<Detection>& selected);

}  // namespace bw::people
