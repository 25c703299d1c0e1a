// bandwagon reproduce SUBJECT: a table or figure of the dissertation again, as a page and results.json.
#pragma once

#include <filesystem>

namespace bw {

struct ReproduceArguments {
  std::filesystem::path out;  ///< folder; made if missing
  bool quick = false;         ///< few seeds, only the main rows
};

// Each subject writes its files, prints a summary to stdout, progress to stderr, and returns whether all criteria
// of what it judges are met; the last lines of the summary say what that is, and what was tuned.

/// E1 (Figure 2.3) and, where BANDWAGON_SHARED names recorded data, E7: results.json and index.html.
bool reproduce_ekf(const ReproduceArguments& arguments);

/// E2 (Table 2.1): results.json and index.html.
bool reproduce_pf(const ReproduceArguments& arguments);

/// E3 and E4 (Table 3.2, Figure 3.4): results.json and index.html.
bool reproduce_edwa(const ReproduceArguments& arguments);

/// E5 and E6 (Figures 3.7 to 3.9, 3.11, 3.12) without and with ETEB; quick: E6 without the published forms.
bool reproduce_pteb(const ReproduceArguments& arguments);
bool reproduce_eteb(const ReproduceArguments& arguments);

}  // namespace bw
