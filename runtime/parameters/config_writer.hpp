// A parameter struct as the tree it would be read from.
#pragma once

#include <string>
#include <string_view>

#include "runtime/parameters/config_node.hpp"
#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/parameter_value.hpp"

namespace bw {

/// Reads back equal. Located in kOverrideFile, so that paths are read as they stand.
template <class T>
ConfigNode to_config(T& value);

namespace detail {

class ConfigWriter {
 public:
  template <class T>
  void operator()(std::string_view name, T& value, const Field& = {}) {
    root_.map.push_back({std::string(name), root_.where, to_config(value)});
  }
  ConfigNode take() { return std::move(root_); }

 private:
  ConfigNode root_{.kind = ConfigNode::Kind::kMap, .where = {std::string(kOverrideFile), 0}};
};

}  // namespace detail

template <class T>
ConfigNode to_config(T& value) {
  if constexpr (HasFields<T>) {
    detail::ConfigWriter writer;
    value.fields(writer);
    return writer.take();
  } else if constexpr (ListField<T>) {
    ConfigNode list{.kind = ConfigNode::Kind::kSequence, .where = {std::string(kOverrideFile), 0}};
    for (typename T::value_type element : value) list.sequence.push_back(to_config(element));
    return list;
  } else if constexpr (IntegerField<T>) {
    return to_config_node(static_cast<std::int64_t>(value));
  } else if constexpr (ChoiceField<T>) {
    return to_config_node(std::string(text_of(value)));
  } else {
    return to_config_node(value);
  }
}

}  // namespace bw
