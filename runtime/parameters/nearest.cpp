#include "runtime/parameters/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace bw {
namespace {

constexpr std::size_t kLongestName = 64;

/// Levenshtein distance, a swap of neighbours counted as one step; `limit` if it is not below that. Keeps its
/// memory from word to word.
class EditDistance {
 public:
  std::size_t operator()(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t shortest = std::min(a.size(), b.size());
    if (std::max(a.size(), b.size()) - shortest >= limit) return limit;
    before_.resize(b.size() + 1);
    row_.resize(b.size() + 1);
    last_.resize(b.size() + 1);
    std::iota(last_.begin(), last_.end(), std::size_t{0});
    std::size_t least_before = 0;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      const std::size_t least = next_row(a, b, i);
      // A row is reached from the two above it, so that nothing gets below both.
      if (std::min(least, least_before) >= limit) return limit;
      least_before = least;
    }
    return std::min(last_[b.size()], limit);
  }

 private:
  /// Row `i` becomes the last one; its least element.
  std::size_t next_row(std::string_view a, std::string_view b, std::size_t i) {
    row_[0] = i;
    std::size_t least = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last_[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row_[j] = std::min({last_[j] + 1, row_[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row_[j] = std::min(row_[j], before_[j - 2] + 1);
      least = std::min(least, row_[j]);
    }
    std::swap(before_, last_);
    std::swap(last_, row_);
    return least;
  }

  std::vector<std::size_t> before_, last_, row_;
};

}  // namespace

std::optional<std::string_view> nearest_of(std::string_view name,
                                           const std::vector<std::string_view>& known) {
  if (name.empty() || name.size() > kLongestName) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t smallest = 1 + std::max<std::size_t>(1, name.size() / 3);
  EditDistance edit_distance;
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(name, candidate.substr(0, kLongestName), smallest);
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
