#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "components/tools/experiments/ekf_report.hpp"
#include "components/tools/experiments/honesty.hpp"
#include "components/tools/experiments/project_file.hpp"
#include "components/tools/experiments/recorded_logs.hpp"
#include "components/tools/experiments/reproduce.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

constexpr int kSeeds = 100;
constexpr int kQuickSeeds = 10;
constexpr int kRealSeeds = 10;
constexpr int kQuickRealSeeds = 2;

void print(const EkfReport& report) {
  fmt::print("{:24} {:7} {:8} {:>12} {:>9} {:>12} {:>9}\n", "sensors", "way", "filter", "published ME", "ME",
             "published", "variance");
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.way);
    fmt::print("{:24} {:7} {:8} {:12.4f} {:9.4f} {:12.4f} {:9.4f}\n", row.sensors.name, to_string(row.way),
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
  EkfReport report{.seeds = arguments.quick ? kQuickSeeds : kSeeds};
  std::cerr << fmt::format("simulated drives, {} seeds\n", report.seeds);
  report.rows = ekf_rows(report.seeds);
  if (const char* shared = std::getenv("BANDWAGON_SHARED")) {
    const RealDataLogs logs =
        read_real_data(std::filesystem::path(shared) / "data", project_file("config/imports"));
    std::cerr << fmt::format("logs of real robots: {}, {}, {}\n", logs.husky.name, logs.mrclam.name,
                             logs.labyrinth.name);
    report.real_data = run_real_data(logs, arguments.quick ? kQuickRealSeeds : kRealSeeds, !arguments.quick);
  } else {
    report.real_data_missing = "BANDWAGON_SHARED names no folder of recorded data";
  }
  nlohmann::ordered_json json = ekf_json(report);
  json["tuned_to_published"] = tuned_to_published("ekf");
  write_file_atomically(arguments.out / "results.json", json.dump(2) + "\n");
  write_file_atomically(arguments.out / "index.html", ekf_page(report));
  print(report);
  const std::vector<Criterion> criteria = all_criteria(report);
  fmt::print("{}written: {}\n",
             closing_lines("ekf", "the EKF, simulated and on logs where they are at hand", criteria),
             (arguments.out / "index.html").string());
  return all_met(criteria);
}

}  // namespace bw
