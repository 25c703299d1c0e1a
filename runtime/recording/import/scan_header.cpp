#include "runtime/recording/import/scan_header.hpp"

#include <algorithm>
#include <string_view>

namespace bw::imports {

void complete_scan(const std::vector<ValueRule>& rules, MessageDraft& scan) {
  const auto is_given = [&rules](std::string_view field) {
    return std::ranges::any_of(rules, [field](const ValueRule& rule) { return rule.field == field; });
  };
  const auto number = [&scan](std::string_view field) { return scan.numbers(scan.find(field)).front(); };
  const std::size_t beams = scan.numbers(scan.find("ranges")).size();
  if (beams < 2) return;
  const double steps = static_cast<double>(beams) - 1.0;
  if (!is_given("angle_max")) {
    scan.set(scan.find("angle_max"), number("angle_min") + steps * number("angle_increment"));
  } else if (!is_given("angle_increment")) {
    scan.set(scan.find("angle_increment"), (number("angle_max") - number("angle_min")) / steps);
  }
}

}  // namespace bw::imports
