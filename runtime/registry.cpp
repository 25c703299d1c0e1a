#include "runtime/registry.hpp"

#include <map>
#include <stdexcept>

#include <dlfcn.h>

#include "runtime/fault.hpp"
#include "runtime/parameters/nearest.hpp"

namespace bw {
namespace {

std::map<std::string, ComponentFactory>& factories() {
  static std::map<std::string, ComponentFactory> all;
  return all;
}

std::map<std::string, FaultKind>& fault_kinds() {
  static std::map<std::string, FaultKind> all;
  return all;
}

}  // namespace

bool register_component(const std::string& type_name, ComponentFactory factory) {
  if (!factories().emplace(type_name, std::move(factory)).second) {
    throw std::logic_error("two components call themselves " + type_name);
  }
  return true;
}

bool register_fault(FaultKind kind) {
  const std::string name = kind.name;
  if (!fault_kinds().emplace(name, std::move(kind)).second)
    throw std::logic_error("two kinds of fault call themselves " + name);
  return true;
}

std::vector<FaultKind> registered_faults() {
  std::vector<FaultKind> kinds;
  for (const auto& [name, kind] : fault_kinds()) kinds.push_back(kind);
  return kinds;
}

std::vector<std::string> registered_components() {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories()) names.push_back(name);
  return names;
}

std::unique_ptr<Component> make_component(const std::string& type_name) {
  const auto found = factories().find(type_name);
  return found == factories().end() ? nullptr : found->second();
}

void load_plugin(const std::filesystem::path& library) {
  // Never closed: the factories live in it.
  if (dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL) == nullptr) {
    throw std::runtime_error("cannot load the component library " + library.string() + ": " + dlerror());
  }
}

}  // namespace bw
