// Services of the simulated world for whoever watches: one more person, a push.
#pragma once

#include "components/world/world.hpp"
#include "runtime/component.hpp"

namespace bw {

/// add_person and push_person, each refused with its reason. `usual_radius` [m]: of a person whose radius the
/// request leaves open. `world` must outlive the services.
void offer_people_services(Setup& setup, World& world, double usual_radius);

}  // namespace bw
