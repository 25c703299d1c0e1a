// A footprint as a parameter: a text in Nav2's form. In YAML a list does as well; what is no footprint is refused where it
// was written.
#pragma once

#include <string>
#include <string_view>

#include "components/model/footprint_outline.hpp"
#include "runtime/base/field.hpp"

namespace bw {

namespace detail {

/// "[[0.2, 0.1], ...]" of a list of lists in a configuration.
template <class Node>
std::string text_of_list(const Node& node) {
  if (!node.is_sequence()) return node.text();
  std::string text = "[";
  for (const Node& element : node.sequence) {
    if (text.size() > 1) text += ", ";
    text += text_of_list(element);
  }
  return text + "]";
}

}  // namespace detail

/// For fields(v). Empty: none.
template <class Visitor>
void footprint_field(Visitor& v, std::string_view name, std::string& text, const Field& field) {
  if constexpr (requires { v.refuse(*v.find(name), name, std::string()); }) {
    const auto* node = v.find(name);
    const bool is_list = node != nullptr && node->is_sequence();
    is_list ? void(text = detail::text_of_list(*node)) : v(name, text, field);
    if (node == nullptr || !(is_list || node->is_scalar())) return;
    if (std::string fault = footprint_of(text, 0.0).fault; !fault.empty())
      v.refuse(*node, name, std::move(fault));
  } else {
    v(name, text, field);
  }
}

}  // namespace bw
