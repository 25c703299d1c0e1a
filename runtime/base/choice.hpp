// A choice among a few named things: an enum, and one table that says which text stands for which value. The
// table lies beside the enum, in its namespace:
//
//   enum class Driver { simulated, serial };
//   constexpr auto choice_table(Driver) {
//     return choices<Driver>({{Driver::simulated, "simulated"}, {Driver::serial, "serial"}});
//   }
//
// Such an enum can be a field of a parameter struct (field.hpp), alone or in a std::vector: files are read
// and checked, values listed and written by the table. An algorithm sees the enum alone, so that a mistyped
// name does not compile and a switch that forgets one warns.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bw {

template <class Enum>
struct Choice {
  Enum value;
  std::string_view text;  ///< as files and lists have it
};

/// The result of choice_table: every value of the enum once, in the order in which people should read them.
template <class Enum, std::size_t kCount>
constexpr std::array<Choice<Enum>, kCount> choices(const Choice<Enum> (&table)[kCount]) {
  return std::to_array(table);
}

/// An enum with a table.
template <class T>
concept ChoiceField = std::is_enum_v<T> && requires(T value) {
  { choice_table(value)[0] } -> std::convertible_to<Choice<T>>;
};

/// Empty for a value that the table does not have.
template <ChoiceField Enum>
constexpr std::string_view text_of(Enum value) {
  for (const Choice<Enum>& choice : choice_table(value)) {
    if (choice.value == value) return choice.text;
  }
  return {};
}

/// Nothing for a text that the table does not have.
template <ChoiceField Enum>
constexpr std::optional<Enum> choice_of(std::string_view text) {
  for (const Choice<Enum>& choice : choice_table(Enum{})) {
    if (choice.text == text) return choice.value;
  }
  return std::nullopt;
}

/// All texts, in the order of the table.
template <ChoiceField Enum>
std::vector<std::string_view> choice_texts() {
  std::vector<std::string_view> texts;
  for (const Choice<Enum>& choice : choice_table(Enum{})) texts.push_back(choice.text);
  return texts;
}

}  // namespace bw
