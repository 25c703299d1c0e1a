// A parameter struct as YAML that reads back equal: `bandwagon param dump`, run manifests.
#pragma once

#include <string>
#include <string_view>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw {

template <class T>
std::string flow_text(T& value);

namespace detail {

/// The visitor behind a struct on one line: {x: 1.0, y: 2.0}.
class FlowWriter {
 public:
  template <class T>
  void operator()(std::string_view name, T& value, const Field& = {}) {
    text_.append(text_.empty() ? "" : ", ").append(name).append(": ").append(flow_text(value));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The visitor behind a struct in block style; lists of structs have one line per element.
class BlockWriter {
 public:
  explicit BlockWriter(std::size_t indent) : margin_(indent, ' ') {}

  template <class T>
  void operator()(std::string_view name, T& value, const Field& = {}) {
    text_.append(margin_).append(name).append(":");
    if constexpr (HasFields<T>) {
      BlockWriter nested(margin_.size() + 2);
      value.fields(nested);
      text_.append(nested.text_.empty() ? " {}\n" : "\n" + nested.text_);
      return;
    } else if constexpr (ListField<T>) {
      if constexpr (HasFields<typename T::value_type>) {
        if (!value.empty()) {
          text_.append("\n");
          for (auto& element : value)
            text_.append(margin_).append("  - ").append(flow_text(element)).append("\n");
          return;
        }
      }
    }
    text_.append(" ").append(flow_text(value)).append("\n");
  }
  const std::string& text() const { return text_; }

 private:
  std::string margin_;
  std::string text_;
};

}  // namespace detail

/// Any field value as YAML on one line.
template <class T>
std::string flow_text(T& value) {
  if constexpr (HasFields<T>) {
    detail::FlowWriter writer;
    value.fields(writer);
    return "{" + writer.text() + "}";
  } else if constexpr (ListField<T>) {
    std::string text;
    for (typename T::value_type element : value)
      text.append(text.empty() ? "" : ", ").append(flow_text(element));
    return "[" + text + "]";
  } else if constexpr (IntegerField<T>) {
    return to_text(static_cast<std::int64_t>(value));
  } else if constexpr (ChoiceField<T>) {
    return to_text(std::string(text_of(value)));
  } else {
    return to_text(value);
  }
}

/// The struct's fields as a block map, every line indented by `indent` blanks.
template <HasFields T>
std::string to_yaml(T value, std::size_t indent = 0) {
  detail::BlockWriter writer(indent);
  value.fields(writer);
  return writer.text().empty() ? std::string(indent, ' ') + "{}\n" : writer.text();
}

}  // namespace bw
