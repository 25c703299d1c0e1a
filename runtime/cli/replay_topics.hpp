// bandwagon replay BAG... without --graph: the bag's topics in real time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/verb.hpp"

namespace bw::cli {

struct ReplayTopicsOptions {
  double rate = 1.0;
  double start_s = 0.0;
  double duration_s = 0.0;
  std::vector<std::string> topics;
  std::string exclude;
  std::vector<std::string> remap;  ///< FROM:=TO
  std::vector<std::string> wait_for;
  bool pause = false;
};

/// Adds them to the verb `replay`.
void add_replay_topics_options(Verb verb, ReplayTopicsOptions& options);

/// The options of the verb that were given and belong to this way of replaying alone, for a refusal; else
/// empty.
[[nodiscard]] std::string given_replay_topics_option(Verb verb);

/// `clock_hz`: publishes /clock. Exit status 1 when it was interrupted or the bag is damaged.
int replay_topics(const std::vector<std::string>& paths, const ReplayTopicsOptions& options,
                  std::optional<double> clock_hz);

}  // namespace bw::cli
