#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "components/lab/experiments/ekf_report.hpp"
#include "components/lab/experiments/published_values.hpp"
#include "components/lab/experiments/recorded_logs.hpp"
#include "components/lab/experiments/reproduce_report.hpp"

namespace bw {
namespace {

constexpr int kQuickEkfSeeds = 10;
constexpr int kQuickRealSeeds = 2;

void print(const EkfReport& report) {
  fmt::print("{:24} {:7} {:8} {:>12} {:>9} {:>12} {:>9}\n", "sensors", "way", "filter", "published ME", "ME",
             "published", "variance");
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.path);
    fmt::print("{:24} {:7} {:8} {:12.4f} {:9.4f} {:12.4f} {:9.4f}\n", row.sensors.name, to_string(row.path),
               to_string(row.noise), row.sensors.published_mean[w], row.mean.mean,
               row.sensors.published_variance[w], row.mean.variance);
  }
  if (report.real_data) {
    for (const NamedLog& log : report.real_data->logs)
      fmt::print("log {} from {}, licence: {}\n", log.name, log.source, log.licence);
    for (const RealDataRow& row : report.real_data->rows)
      fmt::print("{:18} {:64} {:44} reference {:12} mean {:.3f} m\n", row.log, row.task, row.sensors,
                 row.reference, row.mean);
  } else {
    fmt::print("real data: not run: {}\n", report.real_data_missing);
  }
  fmt::print("{}", criteria_text(all_criteria(report)));
}

}  // namespace

bool reproduce_ekf(const ReproduceArguments& arguments) {
  EkfReport report{.seeds = arguments.quick ? kQuickEkfSeeds : kEkfSeeds};
  std::cerr << fmt::format("simulated drives, {} seeds\n", report.seeds);
  report.rows = ekf_rows(report.seeds);
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared != nullptr && *shared != '\0') {
    const RealDataLogs logs = read_real_data(std::filesystem::path(shared) / "data");
    std::cerr << fmt::format("logs of real robots: {}, {}, {}\n", logs.husky.name, logs.mrclam.name,
                             logs.labyrinth.name);
    report.real_data =
        run_real_data(logs, arguments.quick ? kQuickRealSeeds : kRealDataSeeds, !arguments.quick);
  } else {
    report.real_data_missing = "BANDWAGON_SHARED names no folder of recorded data";
  }
  print(report);
  return write_report({.subject = "ekf",
                       .judged = "the EKF, simulated and on logs where they are at hand",
                       .criteria = all_criteria(report),
                       .published = published_values(report),
                       .results = ekf_json(report),
                       .page = ekf_page(report)},
                      arguments);
}

}  // namespace bw
