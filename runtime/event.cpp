#include "runtime/event.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bw {
namespace {

std::vector<DeclaredEvent>& events() {
  static std::vector<DeclaredEvent> all;
  return all;
}

}  // namespace

bool register_event(DeclaredEvent event) {
  const auto found = std::ranges::lower_bound(events(), event.name, {}, &DeclaredEvent::name);
  if (found != events().end() && found->name == event.name)
    throw std::logic_error("two events call themselves " + event.name);
  events().insert(found, std::move(event));
  return true;
}

const std::vector<DeclaredEvent>& registered_events() { return events(); }

}  // namespace bw
