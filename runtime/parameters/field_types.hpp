// What a parameter field may be, asked of its C++ type.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

namespace detail {

struct AnyVisitor {
  template <class T>
  void operator()(std::string_view, T&, const Field& = {}) {}
};

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;

}  // namespace detail

template <class T>
concept HasFields = requires(T& t, detail::AnyVisitor& visitor) {
  t.fields(visitor);
};

template <class T>
concept HasRule = requires(const T& t) {
  { t.violated_rule() } -> std::convertible_to<std::optional<std::string>>;
};

template <class T>
concept ListField = detail::kIsVector<T>;

template <class T>
concept IntegerField = std::integral<T> && !std::same_as<T, bool>;

/// `path.name`, or `name` at the top.
inline std::string joined(std::string_view path, std::string_view name) {
  return path.empty() ? std::string(name) : std::string(path) + "." + std::string(name);
}

}  // namespace bw
