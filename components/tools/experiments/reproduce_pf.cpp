#include <iostream>

#include <fmt/format.h>

#include "components/tools/experiments/honesty.hpp"
#include "components/tools/experiments/pf_report.hpp"
#include "components/tools/experiments/reproduce.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kSeeds = 100;
constexpr std::uint64_t kQuickSeeds = 5;

void print(const PfTable& table) {
  fmt::print("{:14} {:>10} {:>10}", "under the roof", "pub. enc.", "pub. prop.");
  for (const PfMethod method : kPfMethods) fmt::print(" {:>22}", to_string(method));
  fmt::print("\n");
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    fmt::print("{:14} {:10.4f} {:10.4f}", kPfRows[row].name, kPfRows[row].published_encoder,
               kPfRows[row].published_proposed);
    for (const PfCell& cell : table.cells[row]) fmt::print(" {:22.4f}", cell.mean);
    fmt::print("\n");
  }
  fmt::print("{}", criteria_text(table.criteria));
}

}  // namespace

bool reproduce_pf(const ReproduceArguments& arguments) {
  const auto progress = [](const PfRow& row, const PfCell& cell, int done, int all) {
    std::cerr << fmt::format("[{}/{}] {} {}: {:.4f} m\n", done, all, row.name, to_string(cell.method),
                             cell.mean);
  };
  const PfExperimentOptions options{.last_seed = arguments.quick ? kQuickSeeds : kSeeds};
  const PfTable table = run_pf_experiments(options, progress);
  nlohmann::ordered_json json = pf_json(table);
  json["tuned_to_published"] = tuned_to_published("pf");
  write_file_atomically(arguments.out / "results.json", json.dump(2) + "\n");
  write_file_atomically(arguments.out / "index.html", pf_page(table));
  print(table);
  fmt::print("{}written: {}\n",
             closing_lines("pf", "the particle filter with Gaussian weights", table.criteria),
             (arguments.out / "index.html").string());
  return all_met(table.criteria);
}

}  // namespace bw
