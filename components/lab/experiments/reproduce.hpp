// bandwagon reproduce SUBJECT: a table or figure of the dissertation again, as a page and results.json.
#pragma once

#include <cstddef>
#include <filesystem>

namespace bw {

/// Every `count`-th piece of the work, beginning with the `index`-th.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;

  bool is_all() const { return count == 1; }
  bool has(std::size_t piece) const { return piece % count == index - 1; }
};

struct ReproduceArguments {
  std::filesystem::path out;  ///< folder; made if missing
  bool quick = false;         ///< few seeds, only the main rows
  Shard shard = {};  ///< not all: finished drives are left in the folder, for the run that makes the page
  bool simulated_drivers =
      false;     ///< navigation: the world rotates the wheels, without emulated bases and lasers
  int jobs = 1;  ///< all: processes at a time
};

// Each subject writes its files, prints a summary to stdout, progress to stderr, and returns whether all
// criteria of what it judges are met; the last lines of the summary say what that is, and what was tuned.

/// E1 (Figure 2.3) and, where BANDWAGON_SHARED names recorded data, E7: results.json and index.html.
bool reproduce_ekf(const ReproduceArguments& arguments);

/// E2 (Table 2.1): results.json and index.html.
bool reproduce_pf(const ReproduceArguments& arguments);

/// E3 and E4 (Table 3.2, Figure 3.4): results.json and index.html.
bool reproduce_edwa(const ReproduceArguments& arguments);

/// E5 and E6 (Figures 3.7 to 3.9, 3.11, 3.12) without and with ETEB; quick: E6 without the published forms.
bool reproduce_pteb(const ReproduceArguments& arguments);
bool reproduce_eteb(const ReproduceArguments& arguments);

/// The whole system on the source's two robots (Figures 3.5 and 3.13, section 3.4).
bool reproduce_navigation(const ReproduceArguments& arguments);

/// All of them, each in a folder and a process of its own, and one page; what an earlier run finished is not
/// done again.
bool reproduce_all(const ReproduceArguments& arguments);

}  // namespace bw
