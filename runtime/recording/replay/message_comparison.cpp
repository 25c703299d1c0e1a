#include "runtime/recording/replay/message_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/wire/leaves.hpp"

namespace bw::replay {
namespace {

constexpr std::string_view kSeconds = ".sec";
constexpr std::string_view kNanoseconds = ".nanosec";

/// ranges[17] -> ranges
std::string without_indexes(const std::string& path) {
  std::string out;
  bool inside = false;
  for (const char c : path) {
    if (c == '[') inside = true;
    if (!inside) out += c;
    if (c == ']') inside = false;
  }
  return out;
}

/// A value, or the two parts of a stamp.
struct Item {
  std::string path;
  LeafValue value;
  std::optional<std::int64_t> nanoseconds = std::nullopt;  ///< of a stamp or duration, all together
};

std::vector<Item> items_of(const TypeDescription& type, bag::BytesView cdr) {
  std::vector<Leaf> leaves = leaves_of(type, cdr);
  std::vector<Item> items;
  items.reserve(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const std::string& path = leaves[i].path;
    if (path.ends_with(kSeconds) && i + 1 < leaves.size()) {
      const std::string parent = path.substr(0, path.size() - kSeconds.size());
      const auto* seconds = std::get_if<std::int64_t>(&leaves[i].value);
      const auto* rest = std::get_if<std::uint64_t>(&leaves[i + 1].value);
      if (seconds != nullptr && rest != nullptr && leaves[i + 1].path == parent + std::string(kNanoseconds)) {
        items.push_back({parent, false, *seconds * 1'000'000'000 + static_cast<std::int64_t>(*rest)});
        ++i;
        continue;
      }
    }
    items.push_back({std::move(leaves[i].path), std::move(leaves[i].value)});
  }
  return items;
}

std::string hex_of(bag::BytesView bytes) {
  constexpr std::size_t kMax = 32;
  return fmt::format(
      "{} bytes: {:02x}{}", bytes.size(),
      fmt::join(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kMax)), ""),
      bytes.size() > kMax ? "..." : "");
}

std::string text_of(const Item& item) {
  if (!item.nanoseconds) return to_text(item.value);
  return fmt::format("{:.9f} s", Time{*item.nanoseconds}.to_seconds());
}

/// Of two numbers; nothing where one is none. Equal infinities and NaN beside NaN are 0 apart.
std::optional<double> distance(const Item& a, const Item& b) {
  if (a.nanoseconds && b.nanoseconds)
    return std::abs(static_cast<double>(*a.nanoseconds - *b.nanoseconds)) * 1e-9;
  const auto number = [](const LeafValue& value) -> std::optional<double> {
    if (const auto* v = std::get_if<double>(&value)) return *v;
    if (const auto* v = std::get_if<std::int64_t>(&value)) return static_cast<double>(*v);
    if (const auto* v = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*v);
    return std::nullopt;
  };
  const auto x = number(a.value);
  const auto y = number(b.value);
  if (!x || !y) return std::nullopt;
  if (*x == *y || (std::isnan(*x) && std::isnan(*y))) return 0.0;
  const double apart = std::abs(*x - *y);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

}  // namespace

MessageDifference compare_messages(const TypeDescription* type, bag::BytesView recorded,
                                   bag::BytesView replayed, const TopicTolerances& tolerances) {
  MessageDifference result;
  if (std::ranges::equal(recorded, replayed)) return result;
  const auto old_items = type == nullptr ? std::vector<Item>() : items_of(*type, recorded);
  const auto new_items = type == nullptr ? std::vector<Item>() : items_of(*type, replayed);
  if (old_items.empty() || new_items.empty()) {
    result.first = {"bytes", hex_of(recorded), hex_of(replayed)};
    return result;
  }
  for (std::size_t i = 0; i < std::min(old_items.size(), new_items.size()); ++i) {
    const Item& a = old_items[i];
    const Item& b = new_items[i];
    const bool is_same_field = a.path == b.path;
    if (is_same_field && a.value == b.value && a.nanoseconds == b.nanoseconds) continue;
    const std::string field = without_indexes(a.path);
    if (tolerances.leaves_out(field)) continue;
    const auto apart = is_same_field ? distance(a, b) : std::nullopt;
    if (apart && *apart > result.largest) {
      result.largest = *apart;
      result.largest_field = a.path;
    }
    if (apart && *apart <= tolerances.allowed(field)) continue;
    if (!result.first) result.first = {a.path, text_of(a), text_of(b)};
    if (!is_same_field) break;  // sequences of other lengths: what follows is not the same field
  }
  // Another zero, NaN or padding: no field tells, but the bytes are not the same.
  const bool is_exact = tolerances.absolute.empty() && tolerances.left_out.empty();
  if (!result.first && is_exact) result.first = {"bytes", hex_of(recorded), hex_of(replayed)};
  return result;
}

}  // namespace bw::replay
