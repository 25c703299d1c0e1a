// Whether a sweep would have shown something at a position.
#pragma once

#include "components/people/detection.hpp"

namespace bw::people {

/// True when the beam through `position` (in O) passes it by at least `margin` [m]: nothing is there. False
/// when something hides it, when it is out of view, and when the beam was unusable.
bool seen_empty(const DetectionSet& sweep, const Vector2& position, double margin);

}  // namespace bw::people
