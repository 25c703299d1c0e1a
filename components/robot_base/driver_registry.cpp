#include "components/robot_base/driver_registry.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace bw {
namespace {

std::map<std::string, DriverType, std::less<>>& types() {
  static std::map<std::string, DriverType, std::less<>> all;
  return all;
}

}  // namespace

bool register_driver(std::string_view name, DriverType type) {
  if (!types().emplace(std::string(name), std::move(type)).second)
    throw std::logic_error("two drivers call themselves " + std::string(name));
  return true;
}

const DriverType* find_driver(std::string_view name) {
  const auto found = types().find(name);
  return found == types().end() ? nullptr : &found->second;
}

std::vector<std::string> registered_drivers() {
  std::vector<std::string> names;
  for (const auto& [name, type] : types()) names.push_back(name);
  return names;
}

}  // namespace bw
