#include "runtime/graph/event.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace bw {
namespace {

constexpr std::array<std::pair<EventRule, std::string_view>, 6> kRules = {
    {{EventRule::is, "is"},
     {EventRule::is_not, "is_not"},
     {EventRule::above, "above"},
     {EventRule::below, "below"},
     {EventRule::begins_with, "begins_with"},
     {EventRule::rises, "rises"}}};

}  // namespace

std::string to_text(EventRule rule) {
  for (const auto& [known, text] : kRules) {
    if (known == rule) return std::string(text);
  }
  return "unknown";
}

std::optional<EventRule> event_rule_of(std::string_view text) {
  for (const auto& [rule, known] : kRules) {
    if (known == text) return rule;
  }
  return std::nullopt;
}

}  // namespace bw
