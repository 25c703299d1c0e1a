#include <iostream>

#include <fmt/format.h>

#include "components/lab/experiments/pf_report.hpp"
#include "components/lab/experiments/published_values.hpp"
#include "components/lab/experiments/reproduce_report.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kQuickPfSeeds = 5;

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
  const PfExperimentOptions options{.last_seed = arguments.quick ? kQuickPfSeeds : kPfSeeds};
  const PfTable table = run_pf_experiments(options, progress);
  print(table);
  return write_report(
      {.subject = "pf",
       .judged = "the particle filter with Gaussian weights",
       .criteria = table.criteria,
       .published = published_values(table),
       .results = pf_json(table),
       .page = pf_page(table),
       .other_readings = {{"weights as printed, errors in sigma", pf_criteria(table, PfMethod::printed)},
                          {"weights as printed, errors as they are",
                           pf_criteria(table, PfMethod::printed_unscaled)}}},
      arguments);
}

}  // namespace bw
