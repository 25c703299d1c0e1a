// Runs components of a graph again on what a bag holds of the others, and compares what they write.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/graph/graph.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/replay/input_order.hpp"
#include "runtime/recording/replay/output_comparison.hpp"

namespace bw::replay {

struct ReplayOptions {
  std::vector<std::string> run;       ///< names of components of the graph
  std::filesystem::path update = {};  ///< a new bag: the recorded inputs with the new outputs; empty: none
  bool with_text = false;             ///< fills ReplayResult::text
};

struct ReplayResult {
  std::map<std::string, TopicVerdict> topics;
  std::string first_topic;      ///< with the earliest difference; empty: all equal
  std::uint64_t compared = 0;   ///< messages
  std::uint64_t published = 0;  ///< messages of the bag
  std::uint64_t malformed = 0;  ///< that do not fit their type, left out
  std::string sha256;           ///< of the outputs now
  std::string text;             ///< outputs as change_text.hpp has them
  Pairing pairing = Pairing::in_order;
  std::optional<OrderVerdict>
      order;                       ///< of a difference that the order of inputs may explain: by_stamp alone
  std::vector<std::string> notes;  ///< what limits the comparison: another build, another CPU type, damage

  [[nodiscard]] bool is_equal() const { return first_topic.empty() && compared > 0; }
};

/// Virtual time that may be replayed to explain a difference by the order of inputs.
constexpr Duration kOrderBudget = Duration::milliseconds(600'000);

/// In lock-step, from the bag's first message to its last, by the tolerances of the graph. Throws ConfigError
/// or std::runtime_error: a component that is not in the graph or writes nothing that was recorded, an input
/// nobody feeds.
[[nodiscard]] ReplayResult replay(const bag::Bag& recording, Graph graph, const ReplayOptions& options);

}  // namespace bw::replay
