#include "runtime/wire/type_registry.hpp"

namespace bw {

const TypeDescription* find_type(std::string_view name) {
  for (const TypeDescription* type : all_types()) {
    if (type->ros_name == name || type->dds_name == name) return type;
  }
  return nullptr;
}

const TypeDescription* find_type(std::string_view name, std::string_view type_hash) {
  const TypeDescription* base = find_type(name);
  if (type_hash.empty() || (base != nullptr && base->type_hash == type_hash)) return base;
  for (const TypeDescription* type : other_layouts()) {
    if (type->type_hash == type_hash && (type->ros_name == name || type->dds_name == name)) return type;
  }
  return nullptr;
}

// What a distribution did not change it has from the one before, back to Jazzy; Humble's changes are its own.
const TypeDescription* find_type(std::string_view name, RosDistro distro) {
  const auto layouts = other_layouts();
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const TypeDescription* type = layouts[i];
    if (distros_of_other_layouts()[i] == distro && (type->ros_name == name || type->dds_name == name))
      return type;
  }
  return distro == RosDistro::lyrical ? find_type(name, RosDistro::kilted) : find_type(name);
}

}  // namespace bw
