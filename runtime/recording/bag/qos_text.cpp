#include "runtime/recording/bag/qos_text.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace bw::bag {
namespace {

// The numbers of rmw (rmw/types.h).
constexpr int kKeepLast = 1;
constexpr int kUnknownHistory = 3;
constexpr int kReliable = 1;
constexpr int kBestEffort = 2;
constexpr int kTransientLocal = 1;
constexpr int kVolatile = 2;
constexpr int kAutomatic = 1;

constexpr int kLeastPlayingDepth = 10;
constexpr std::int64_t kInfiniteSeconds = 9223372036;

std::string duration_text(std::string_view key, std::optional<Duration> duration) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t sec = duration ? duration->nanoseconds / kSecond : kInfiniteSeconds;
  const std::int64_t nsec = duration ? duration->nanoseconds % kSecond : 854775807;
  return fmt::format("  {}:\n    sec: {}\n    nsec: {}\n", key, sec, nsec);
}

bool says(const YAML::Node& node, std::string_view word, int number) {
  return node && node.IsScalar() && (node.Scalar() == word || node.Scalar() == std::to_string(number));
}

Qos profile_of(const YAML::Node& node) {
  Qos qos;
  qos.depth = std::max(node["depth"].as<int>(qos.depth), 1);
  if (says(node["reliability"], "best_effort", kBestEffort)) qos.reliability = Reliability::best_effort;
  if (says(node["durability"], "transient_local", kTransientLocal))
    qos.durability = Durability::transient_local;
  if (const YAML::Node lifespan = node["lifespan"]; lifespan && lifespan.IsMap()) {
    const auto sec = lifespan["sec"].as<std::int64_t>(kInfiniteSeconds);
    const auto nsec = lifespan["nsec"].as<std::int64_t>(0);
    const bool is_finite = sec >= 0 && sec < kInfiniteSeconds && nsec >= 0 && sec + nsec > 0;
    if (is_finite) qos.lifespan = Duration{sec * 1'000'000'000 + nsec};
  }
  return qos;
}

}  // namespace

std::string to_qos_text(const std::vector<Qos>& offered) {
  std::string text;
  for (const Qos& qos : offered) {
    text += fmt::format("- history: {}\n  depth: {}\n  reliability: {}\n  durability: {}\n",
                        qos.depth > 0 ? kKeepLast : kUnknownHistory, qos.depth,
                        qos.reliability == Reliability::reliable ? kReliable : kBestEffort,
                        qos.durability == Durability::transient_local ? kTransientLocal : kVolatile);
    text += duration_text("deadline", std::nullopt) + duration_text("lifespan", qos.lifespan);
    text += fmt::format("  liveliness: {}\n", kAutomatic);
    text += duration_text("liveliness_lease_duration", std::nullopt);
    text += "  avoid_ros_namespace_conventions: false\n";
  }
  return text;
}

std::vector<Qos> from_qos_text(const std::string& text) {
  std::vector<Qos> profiles;
  try {
    const YAML::Node list = YAML::Load(text);
    if (!list.IsSequence()) return {};
    for (const YAML::Node& node : list) {
      if (!node.IsMap()) return {};
      profiles.push_back(profile_of(node));
    }
  } catch (const YAML::Exception&) {
    return {};
  }
  return profiles;
}

Qos playing_qos(const std::vector<Qos>& offered) {
  const auto agrees = [&](const Qos& qos) {
    return qos.reliability == offered.front().reliability && qos.durability == offered.front().durability;
  };
  if (offered.empty() || !std::ranges::all_of(offered, agrees)) return Qos::standard(kLeastPlayingDepth);
  Qos qos = offered.front();
  for (const Qos& other : offered) qos.depth = std::max(qos.depth, other.depth);
  qos.depth = std::max(qos.depth, kLeastPlayingDepth);
  return qos;
}

}  // namespace bw::bag
