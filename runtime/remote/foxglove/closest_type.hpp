// A parameter's value as text formats have it, which tell no integer from a double, as the type that the
// parameter has.
#pragma once

#include "runtime/parameters/parameter_value.hpp"

namespace bw::foxglove {

/// `value` with the type of `like` where nothing is lost: 1 is 1.0, 2.0 is 2, an empty list is one of any
/// type. Else as it is: the node says what is wrong with it.
[[nodiscard]] ParameterValue closest_type(const ParameterValue& value, const ParameterValue& like);

}  // namespace bw::foxglove
