#include "idl/compiler/names.hpp"

#include <algorithm>

namespace bw::idl {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

bool is_snake(std::string_view name, bool (*is_letter)(char)) {
  return !name.empty() && is_letter(name.front()) && name.back() != '_' &&
         name.find("__") == std::string_view::npos && std::all_of(name.begin(), name.end(), [&](char c) {
           return is_letter(c) || is_digit(c) || c == '_';
         });
}

}  // namespace

bool is_field_name(std::string_view name) { return is_snake(name, is_small); }

bool is_type_name(std::string_view name) {
  return !name.empty() && is_capital(name.front()) && std::all_of(name.begin(), name.end(), [](char c) {
    return is_capital(c) || is_small(c) || is_digit(c);
  });
}

bool is_constant_name(std::string_view name) { return is_snake(name, is_capital); }

}  // namespace bw::idl
