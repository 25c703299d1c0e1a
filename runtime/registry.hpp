// The component types this process knows, built in or loaded from libraries.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/component.hpp"

namespace bw {

/// Sorted by name.
std::vector<std::string> registered_components();

/// Null when the type is unknown.
std::unique_ptr<Component> make_component(const std::string& type_name);

/// Loads a shared library whose BW_COMPONENT lines register themselves. Throws std::runtime_error with the
/// loader's reason.
void load_plugin(const std::filesystem::path& library);

}  // namespace bw
