// A parameter struct as rows for people: `bandwagon param list`, the web panel, the documentation.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/write_parameters.hpp"

namespace bw {

struct ParameterRow {
  std::string name;           ///< dotted; elements of a list of structs by index, as walls.0.x
  std::string type;           ///< bool, integer, double, string (choices too); a list: "double list"
  std::string value;          ///< as YAML
  std::string default_value;  ///< as YAML; empty for list elements that the defaults do not have
  std::string unit;
  double min;
  double max;
  std::vector<std::string> choices;
  std::string doc;
};

namespace detail {

template <class T>
std::string type_name() {
  if constexpr (std::same_as<T, bool>)
    return "bool";
  else if constexpr (IntegerField<T>)
    return "integer";
  else if constexpr (std::same_as<T, double>)
    return "double";
  else if constexpr (std::same_as<T, std::string> || ChoiceField<T>)
    return "string";
  else if constexpr (ListField<T>)
    return type_name<typename T::value_type>() + " list";
  else
    return "struct";
}

/// The texts that a field may have; empty: any, or it is no text.
template <class T>
std::vector<std::string_view> texts_allowed(const Field& field) {
  if constexpr (ChoiceField<T>)
    return choice_texts<T>();
  else if constexpr (ListField<T>)
    return texts_allowed<typename T::value_type>(field);
  else
    return field.choices;
}

/// The visitor that collects the rows.
class ParameterLister {
 public:
  ParameterLister(std::string path, std::vector<ParameterRow>& rows) : path_(std::move(path)), rows_(rows) {}

  template <class T>
  void operator()(std::string_view name, T& value, const Field& field = {}) {
    list(joined(path_, name), value, field);
  }

 private:
  template <class T>
  void list(const std::string& name, T& value, const Field& field) {
    if constexpr (HasFields<T>) {
      ParameterLister nested(name, rows_);
      value.fields(nested);
      return;
    } else if constexpr (ListField<T>) {
      if constexpr (HasFields<typename T::value_type>) {
        std::size_t index = 0;
        for (auto& element : value) list(joined(name, std::to_string(index++)), element, field);
        if (!value.empty()) return;
      }
    }
    const std::vector<std::string_view> allowed = texts_allowed<T>(field);
    rows_.push_back({name, type_name<T>(), flow_text(value), "", std::string(field.unit), field.min,
                     field.max, std::vector<std::string>(allowed.begin(), allowed.end()),
                     std::string(field.doc)});
  }

  std::string path_;
  std::vector<ParameterRow>& rows_;
};

}  // namespace detail

/// In the order of the field lists.
template <HasFields T>
std::vector<ParameterRow> list_parameters(T& value, std::string_view prefix = "") {
  std::vector<ParameterRow> rows, defaults;
  T default_value{};
  detail::ParameterLister lister{std::string(prefix), rows}, default_lister{std::string(prefix), defaults};
  value.fields(lister);
  default_value.fields(default_lister);
  std::map<std::string, std::string> text_of;
  for (const ParameterRow& row : defaults) text_of[row.name] = row.value;
  for (ParameterRow& row : rows) {
    if (const auto found = text_of.find(row.name); found != text_of.end()) row.default_value = found->second;
  }
  return rows;
}

}  // namespace bw
