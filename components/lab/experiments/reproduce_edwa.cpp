#include <iostream>
#include <utility>

#include <fmt/format.h>

#include "components/lab/experiments/edwa_report.hpp"
#include "components/lab/experiments/published_values.hpp"
#include "components/lab/experiments/reproduce_report.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kQuickEdwaSeeds = 5;

void print(const EdwaTable& table) {
  fmt::print("{:28} {:10} {:>9} {:>7} {:>7} {:>8} {:>9} {:>9}\n", "scene", "pairing", "published", "mean",
             "sd", "reached", "contacts", "timeouts");
  for (const EdwaRow& row : table.rows) {
    fmt::print("{:28} {:10} {:9.4f} {:7.4f} {:7.4f} {:4}/{:3} {:9} {:9}\n", edwa_scene_name(row.scene),
               to_string(row.pairing), row.published, row.mean, row.sd, row.success, row.runs.size(),
               row.contacts, row.timeouts);
  }
  fmt::print("{}", criteria_text(table.criteria));
}

}  // namespace

bool reproduce_edwa(const ReproduceArguments& arguments) {
  std::vector<EdwaVariant> variants = edwa_variants(1, arguments.quick ? kQuickEdwaSeeds : kEdwaSeeds);
  if (arguments.quick) variants.erase(variants.begin() + 1, variants.end());
  std::vector<EdwaResult> results;
  for (const EdwaVariant& variant : variants) {
    const auto progress = [&](const EdwaRow& row, int done, int all) {
      std::cerr << fmt::format(
          "[{}/{}] {}: {} {} {:.4f} m/s, {}/{} reached\n",
          results.size() * static_cast<std::size_t>(all) + static_cast<std::size_t>(done),
          variants.size() * static_cast<std::size_t>(all), variant.name, edwa_scene_name(row.scene),
          to_string(row.pairing), row.mean, row.success, row.runs.size());
    };
    results.push_back({variant, run_edwa_experiment(variant.options, progress)});
  }
  const EdwaTable& table = results.front().table;
  print(table);
  std::vector<std::pair<std::string, std::vector<Criterion>>> others;
  for (std::size_t i = 1; i < results.size(); ++i)
    others.emplace_back(results[i].variant.name, results[i].table.criteria);
  return write_report({.subject = "edwa",
                       .judged = "EDWA by the published setting",
                       .criteria = table.criteria,
                       .published = published_values(results),
                       .results = edwa_json(results),
                       .page = edwa_page(results),
                       .other_readings = std::move(others)},
                      arguments);
}

}  // namespace bw
