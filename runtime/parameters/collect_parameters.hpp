// The leaves of a parameter struct with names, typed values and descriptors.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/parameters/list_parameters.hpp"
#include "runtime/parameters/parameter_descriptor.hpp"

namespace bw {

struct ParameterEntry {
  std::string name;  ///< dotted; elements of a list of structs by index, as walls.0.x
  std::string list;  ///< the outermost list that it is part of, as walls; empty: none
  ParameterValue value;
  ParameterDescriptor descriptor;
};

namespace detail {

/// A list of which each element has a name of its own: ROS 2 knows no lists of structs or of lists.
template <class T>
inline constexpr bool kIsNamedList = false;
template <class E>
inline constexpr bool kIsNamedList<std::vector<E>> = HasFields<E> || ListField<E>;

template <class T>
ParameterValue leaf_value(const T& value) {
  if constexpr (IntegerField<T>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (ChoiceField<T>) {
    return std::string(text_of(value));
  } else if constexpr (ListField<T>) {
    using Element = typename T::value_type;
    if constexpr (IntegerField<Element>) {
      return std::vector<std::int64_t>(value.begin(), value.end());
    } else if constexpr (ChoiceField<Element>) {
      std::vector<std::string> texts;
      for (const Element element : value) texts.emplace_back(text_of(element));
      return texts;
    } else {
      return value;
    }
  } else {
    return value;
  }
}

/// The visitor that collects the leaves. An empty list of structs has none.
class ParameterCollector {
 public:
  ParameterCollector(std::string path, std::string list, std::vector<ParameterEntry>& entries)
      : path_(std::move(path)), list_(std::move(list)), entries_(entries) {}

  template <class T>
  void operator()(std::string_view name, T& value, const Field& field = {}) {
    add(joined(path_, name), list_, value, field);
  }

 private:
  template <class T>
  void add(const std::string& name, const std::string& list, T& value, const Field& field) {
    if constexpr (HasFields<T>) {
      ParameterCollector nested(name, list, entries_);
      value.fields(nested);
    } else if constexpr (kIsNamedList<T>) {
      std::size_t index = 0;
      for (auto& element : value)
        add(joined(name, std::to_string(index++)), list.empty() ? name : list, element, field);
    } else {
      ParameterValue leaf = leaf_value(value);
      const ParameterType type = type_of(leaf);
      entries_.push_back(
          {name, list, std::move(leaf), describe(type, field, limits_of<T>(), texts_allowed<T>(field))});
    }
  }

  template <class T>
  static IntegerRange limits_of() {
    if constexpr (IntegerField<T>)
      return {static_cast<std::int64_t>(std::numeric_limits<T>::min()),
              static_cast<std::int64_t>(std::min<std::uint64_t>(std::numeric_limits<T>::max(),
                                                                std::numeric_limits<std::int64_t>::max()))};
    return {};
  }

  std::string path_;
  std::string list_;
  std::vector<ParameterEntry>& entries_;
};

}  // namespace detail

/// In the order of the field lists.
template <HasFields T>
std::vector<ParameterEntry> collect_parameters(T& value) {
  std::vector<ParameterEntry> entries;
  detail::ParameterCollector collector("", "", entries);
  value.fields(collector);
  return entries;
}

}  // namespace bw
