// The page of ekf_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/ekf_figures.hpp"
#include "components/lab/experiments/ekf_report.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::sensible;
using page::Table;

constexpr std::string_view kSimulated =
    "<h2>E1: the simulated robot (Figures 2.2 to 2.4)</h2>\n"
    "<p>A robot at 1 m/s with wheels of unequal size (0.85 %), a receiver (1 Hz, 0.18 m) and a compass (1 Hz, "
    "1 degree): a sine-like way of 120 s and one lap of a circle of 33 m.</p>\n";

constexpr std::string_view kFilters =
    "<p><b>placed</b>: the filter takes its wheels for far worse than they are (k = 0.03 m), which is what "
    "puts the fused errors where they were published; no evidence of its quality. <b>matched</b>: the filter "
    "knows its wheels. With a compass and no receiver the error has no bound: its value depends on the length "
    "of the way.</p>\n";

constexpr std::string_view kRealData =
    "<h2>E7: real robots</h2>\n"
    "<p>Error of the position [m] at places that the filter did not know. Husky: outdoors, skid-steered, "
    "against the fixes held out, which err by metres themselves and wander together with those given. "
    "MRCLAM: an iRobot Create, its velocity commands as odometry, against motion capture, from the pose "
    "known at the start. Labyrinth: radio ranges, long by 0.1 m at the median, against its reference. "
    "Reference: an earlier study on the same data, with its own filter and parameters; where none was made "
    "the cell is empty.</p>\n";

std::string top(const EkfReport& report) {
  page::FirstScreen screen{
      .title = "The EKF: Figures 2.2 to 2.4, and real robots",
      .about =
          "What the dissertation publishes of its extended Kalman filter (section 2.2), beside what is measured "
          "here over " +
          std::to_string(report.seeds) + " seeds.",
      .judged =
          report.real_data ? "the filter in simulation and on recorded logs" : "the filter in simulation",
      .criteria = all_criteria(report),
      .not_judged =
          {"The published variance of the encoders alone (6.12 and 5.93 m²): no drift that starts at zero "
           "has it.",
           "The ways themselves: the source shows their shape, and gives no lengths, rates, noises or "
           "number of runs."},
      .tuned = tuned_to_published("ekf")};
  if (!report.real_data)
    screen.not_judged.push_back("Logs of real robots: " + xml_text(report.real_data_missing) + ".");
  return page::first_screen(screen);
}

std::string figure_table(const EkfReport& report) {
  Table table({"sensors", "way", "filter", "ME published [m]", "ME [m]", "1 % [m]", "99 % [m]",
               "variance published [m²]", "variance [m²]", "rms [m]"});
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.way);
    table.row({xml_text(row.sensors.name), std::string(to_string(row.way)), std::string(to_string(row.noise)),
               fixed(row.sensors.published_mean[w], 4), sensible(row.mean.mean),
               sensible(quantile_of_means(row, 0.01)), sensible(quantile_of_means(row, 0.99)),
               fixed(row.sensors.published_variance[w], 4), sensible(row.mean.variance),
               sensible(row.mean.rms)});
  }
  return table.html();
}

std::string parameters(const RealDataResults& results) {
  const RealDataParameters& p = results.parameters;
  return "<p>All that the filter is given, the same for every log: wheels k = " +
         fixed(p.sensors.wheel_noise, 4) + " m (the Labyrinth declares its own), gyro " +
         fixed(p.sensors.gyro_noise, 2) + " rad/s, compass " + fixed(p.sensors.compass_noise, 2) +
         " rad (MRCLAM's is made and declared), a compass whose zero is unknown with an offset of " +
         fixed(p.heading_offset_sigma, 2) +
         " rad; the wheel separations of the bases; variances of fixes and "
         "ranges as the logs declare them. One figure is declared by nobody: position_walk = " +
         fixed(p.position_walk, 2) +
         " m per root metre, how far positions and wheels drift apart by what neither declares. It was "
         "chosen with the Husky's outage in view" +
         (results.walks.empty() ? "" : "; the second table shows what it does") + ".</p>\n";
}

std::string real_data_table(const RealDataResults& results) {
  Table table({"log", "task", "sensors", "reference [m]", "mean [m]", "rms [m]", "largest [m]", "places",
               "from [s]"});
  for (const RealDataRow& row : results.rows) {
    table.row({xml_text(row.log), xml_text(row.task), xml_text(row.sensors), xml_text(row.reference),
               sensible(row.mean), sensible(row.rms), sensible(row.largest), std::to_string(row.count),
               fixed(row.first_pose, 1)});
  }
  return table.html();
}

std::string logs_used(const RealDataResults& results) {
  Table table({"log", "source", "licence"});
  for (const NamedLog& log : results.logs)
    table.row({xml_text(log.name), xml_text(log.source), xml_text(log.licence)});
  return "<h3>Logs</h3>\n" + table.html();
}

std::string walk_table(const RealDataResults& results) {
  Table table({"position_walk [m/√m]", "Husky, every second fix [m]", "Husky, outage [m]",
               "MRCLAM, receiver [m]", "MRCLAM, all [m]", "Labyrinth, ranges [m]"});
  for (const WalkRow& row : results.walks) {
    table.row({fixed(row.position_walk, 2), sensible(row.husky_half), sensible(row.husky_outage),
               sensible(row.mrclam_gps), sensible(row.mrclam_all), sensible(row.labyrinth)});
  }
  return table.html();
}

}  // namespace

std::string ekf_page(const EkfReport& report) {
  std::string html = page::opening("EKF: Figures 2.2 to 2.4", 68) + top(report) + std::string(kSimulated) +
                     ekf_trajectories(report) + ekf_statistics(report) + std::string(kFilters) +
                     figure_table(report) + std::string(kRealData);
  if (!report.real_data)
    return html + "<p>Not run: " + xml_text(report.real_data_missing) + ".</p>" + page::closing();
  return html + ekf_recorded_ways(*report.real_data) + real_data_table(*report.real_data) +
         "<p>MRCLAM: means over seeds 1 to " + std::to_string(report.real_data->seeds) + ".</p>\n" +
         parameters(*report.real_data) + walk_table(*report.real_data) + logs_used(*report.real_data) +
         page::closing();
}

}  // namespace bw
