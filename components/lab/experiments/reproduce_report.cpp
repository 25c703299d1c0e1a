#include "components/lab/experiments/reproduce_report.hpp"

#include <iostream>

#include <fmt/format.h>

#include "components/lab/experiments/caveats.hpp"
#include "components/lab/report/report_page.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/build_identity.hpp"

namespace bw {

nlohmann::ordered_json made_by(const ReproduceArguments& arguments) {
  return {{"program", build_id()}, {"cpu", cpu_type()}, {"quick", arguments.quick}};
}

void write_page(const report::Document& page, const ReproduceArguments& arguments) {
  if (can_draw_reports()) {
    write_report_page(page, arguments.out / "index.html");
  } else {
    std::cerr
        << "this program was built without the page: index.html is left out, the figures are in results.json\n";
  }
}

bool write_report(const ReproduceReport& report, const ReproduceArguments& arguments) {
  nlohmann::ordered_json json = report.results;
  json["judged"] = report.judged;
  json["criteria"] = criteria_json(report.criteria);
  json["other_readings"] = nlohmann::ordered_json::array();
  for (const auto& [name, criteria] : report.other_readings)
    json["other_readings"].push_back({{"name", name}, {"criteria", criteria_json(criteria)}});
  json["published"] = published_json(report.published);
  json["tuned_to_published"] = tuned_to_published(report.subject);
  json["made_by"] = made_by(arguments);
  write_page(report.page, arguments);
  write_file_atomically(arguments.out / "results.json", json.dump(2) + "\n");  // last: it stands for both
  fmt::print("{}", closing_lines(report.subject, report.judged, report.criteria));
  for (const auto& [name, criteria] : report.other_readings)
    fmt::print("not judged by it: {}\n", criteria.empty() ? name + ": not run" : verdict(name, criteria));
  fmt::print("written: {}\n",
             (arguments.out / (can_draw_reports() ? "index.html" : "results.json")).string());
  return all_met(report.criteria);
}

}  // namespace bw
