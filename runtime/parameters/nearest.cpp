#include "runtime/parameters/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace bw {
namespace {

constexpr std::size_t kLongestName = 64;

/// Levenshtein distance, a swap of neighbours counted as one step.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string_view> nearest_of(std::string_view name,
                                           const std::vector<std::string_view>& known) {
  if (name.empty() || name.size() > kLongestName) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t smallest = 1 + std::max<std::size_t>(1, name.size() / 3);
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(name, candidate.substr(0, kLongestName));
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string unknown_rule(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& known) {
  std::string rule = "unknown " + std::string(what);
  if (const auto nearest = nearest_of(name, known))
    return rule + "; did you mean '" + std::string(*nearest) + "'?";
  return known.empty() ? rule + "; there are none" : rule + "; known: " + comma_separated(known);
}

std::string comma_separated(const std::vector<std::string_view>& names) {
  std::string out;
  for (const std::string_view name : names) out.append(out.empty() ? "" : ", ").append(name);
  return out;
}

}  // namespace bw
