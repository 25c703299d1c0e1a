// The component `explore` with options that no graph sets, for benches.
#pragma once

#include <memory>

#include "components/explore/explorer.hpp"
#include "runtime/component.hpp"

namespace bw {

std::unique_ptr<Component> make_explore_component(bool return_to_init);

}  // namespace bw
