// A suite: drives that are judged together, as YAML.
//
//   graph: ../graphs/hallway.yaml     # relative to this file
//   time_limit: 120.0
//   seeds: {first: 1, last: 20}       # every episode is driven with every seed
//   set: [world.people_react=false]   # for all episodes, as `bandwagon run --set`
//   variants:                         # conditions chosen by --variants; the suite as it is has none of them
//     - {name: own, set: [people.enabled=true]}
//   episodes:
//     - name: full
//     - {name: light, set: ["world.people.social.walkers=[]"]}
//
// In `set`, ${NAME} stands for an environment variable, and files are relative to the suite.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/field.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/parameters/overrides.hpp"

namespace bw {

struct SeedRange {
  std::int64_t first = 1;
  std::int64_t last = 1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("first", first, {.min = 0, .max = 1e9, .doc = "first seed"});
    v("last", last, {.min = 0, .max = 1e9, .doc = "last seed, inclusive"});
  }

  std::optional<std::string> violated_rule() const {
    if (last < first) return "last must be at least first";
    return std::nullopt;
  }
};

struct SuiteEpisode {
  std::string name;
  std::vector<std::string> set;

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "unique in the suite; letters, digits, dot, _ and -"});
    v("set", set, {.doc = "component.param=value, after those of the suite"});
  }
};

/// A condition that all episodes may be driven under.
struct SuiteVariant {
  std::string name;
  std::vector<std::string> set;

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "unique in the suite; letters, digits, dot, _ and -"});
    v("set", set, {.doc = "component.param=value, after those of the episode"});
  }
};

struct SuiteOptions {
  std::string graph;
  double time_limit = 180.0;
  SeedRange seeds;
  std::vector<std::string> set;
  std::vector<SuiteVariant> variants;
  std::vector<SuiteEpisode> episodes;

  template <class Visitor>
  void fields(Visitor& v) {
    v("graph", graph, {.doc = "graph file"});
    v("time_limit", time_limit,
      {.unit = "s", .min = 1, .max = 1e5, .doc = "a drive that lasts longer has failed; component clock"});
    v("seeds", seeds, {.doc = "every episode is driven with each"});
    v("set", set, {.doc = "component.param=value, for all episodes"});
    v("variants", variants,
      {.doc = "conditions that all episodes may be driven under, chosen by --variants"});
    v("episodes", episodes, {.doc = "the drives"});
  }

  std::optional<std::string> violated_rule() const;
};

struct Suite {
  SuiteOptions options;
  std::filesystem::path graph;                   ///< resolved
  std::vector<std::vector<Override>> overrides;  ///< of each episode: the suite's, then its own

  std::vector<std::vector<Override>> variant_overrides;  ///< of each variant

  /// `variant`: a name of options.variants; empty: the suite as it is. Throws ConfigError, and
  /// std::runtime_error naming the known variants.
  Graph graph_of(std::size_t episode, const std::string& variant = "") const;
};

/// Names become file names: letters, digits, dot, _ and -, not beginning with a dot, 100 at most.
bool is_episode_name(const std::string& text);

/// Throws ConfigError naming file, line, key and rule; so does an environment variable that is not set.
Suite load_suite(const std::filesystem::path& file);

}  // namespace bw
