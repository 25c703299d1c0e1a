// The page of ekf_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/tools/experiments/ekf_report.hpp"
#include "components/tools/experiments/page_parts.hpp"
#include "components/tools/experiments/path_plot.hpp"

namespace bw {
namespace {

using page::cell;
using page::criteria_table;
using page::head;

constexpr std::string_view kFigure =
    "<h2>E1: Figure 2.3</h2>\n"
    "<p>Mean position error ME [m] and its variance about ME [m<sup>2</sup>], published as \"MSE\", of a "
    "simulated robot: 1 m/s, wheels of unequal size (0.85 %), receiver 1 Hz 0.18 m, compass 1 Hz 1 deg; a "
    "sine-like way of 120 s and one lap of a circle of 33 m. The published values are one run, or an unknown "
    "number, on ways, rates and noises that are not given; those here were chosen with the published values "
    "in view. Agreement shows that the values are attainable with sensible inputs, not that the inputs were "
    "these. What carries evidence is the ordering.</p>\n"
    "<p><b>placed</b>: the filter takes its wheels for far worse than they are (k = 0.03 m), which is what "
    "puts the fused errors where they were published; no evidence of its quality. <b>matched</b>: the filter "
    "knows its wheels. The published variance of the encoders alone fits no drift that starts at zero and is "
    "not judged. With a compass and no receiver the error has no bound: its value depends on the length of "
    "the way.</p>\n";

constexpr std::string_view kRealData =
    "<h2>E7: real robots</h2>\n"
    "<p>Error of the position [m] at places that the filter did not know. Husky: outdoors, skid-steered, "
    "against the fixes held out, which err by metres themselves and wander together with those given. "
    "MRCLAM: an iRobot Create, its velocity commands as odometry, against motion capture, from the pose "
    "known at the start. Labyrinth: radio ranges, long by 0.1 m at the median, against its reference. "
    "Reference: an earlier study on the same data, with its own filter and parameters; where none was made "
    "the cell is empty.</p>\n";

std::string figure_table(const EkfReport& report) {
  std::string html = head({"sensors", "way", "filter", "published ME", "ME", "1 %", "99 %",
                           "published variance", "variance", "rms"});
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.way);
    html += "<tr>" + cell(xml_text(row.sensors.name)) + cell(std::string(to_string(row.way))) +
            cell(std::string(to_string(row.noise))) + cell(fixed(row.sensors.published_mean[w], 4)) +
            cell(fixed(row.mean.mean, 4)) + cell(fixed(quantile_of_means(row, 0.01), 4)) +
            cell(fixed(quantile_of_means(row, 0.99), 4)) + cell(fixed(row.sensors.published_variance[w], 4)) +
            cell(fixed(row.mean.variance, 4)) + cell(fixed(row.mean.rms, 4)) + "</tr>\n";
  }
  return html + "</table>\n";
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
         "chosen with the Husky's outage in view; the second table shows what it does.</p>\n";
}

std::string real_data_table(const RealDataResults& results) {
  std::string html =
      head({"log", "task", "sensors", "reference", "mean", "rms", "largest", "places", "from [s]"});
  for (const RealDataRow& row : results.rows) {
    html += "<tr>" + cell(xml_text(row.log)) + cell(xml_text(row.task)) + cell(xml_text(row.sensors)) +
            cell(xml_text(row.reference)) + cell(fixed(row.mean, 3)) + cell(fixed(row.rms, 3)) +
            cell(fixed(row.largest, 2)) + cell(std::to_string(row.count)) + cell(fixed(row.first_pose, 1)) +
            "</tr>\n";
  }
  return html + "</table>\n";
}

std::string logs_used(const RealDataResults& results) {
  std::string html = "<p>Logs:</p>\n" + head({"log", "source", "licence"});
  for (const NamedLog& log : results.logs) {
    html += "<tr>" + cell(xml_text(log.name)) + cell(xml_text(log.source)) + cell(xml_text(log.licence)) +
            "</tr>\n";
  }
  return html + "</table>\n";
}

std::string walk_table(const RealDataResults& results) {
  if (results.walks.empty()) return "";
  std::string html = head({"position_walk", "Husky, every second fix", "Husky, outage", "MRCLAM, receiver",
                           "MRCLAM, all", "Labyrinth, ranges"});
  for (const WalkRow& row : results.walks) {
    html += "<tr>" + cell(fixed(row.position_walk, 2)) + cell(fixed(row.husky_half, 3)) +
            cell(fixed(row.husky_outage, 3)) + cell(fixed(row.mrclam_gps, 3)) +
            cell(fixed(row.mrclam_all, 3)) + cell(fixed(row.labyrinth, 3)) + "</tr>\n";
  }
  return html + "</table>\n";
}

std::string pictures(const RealDataResults& results) {
  constexpr std::string_view kColors[] = {"#888888", "#1f6fb2", "#b3261e"};
  std::string html;
  for (const RealDataPicture& picture : results.pictures) {
    std::vector<PlotWay> ways;
    for (const RealDataPicture::Way& way : picture.ways) {
      const std::string color(kColors[ways.size() % std::size(kColors)]);
      ways.push_back({way.label, color, way.points, ways.empty()});
    }
    html += path_plot(picture.title, ways);
  }
  return html;
}

}  // namespace

std::string ekf_page(const EkfReport& report) {
  std::string html = page::opening("EKF: Figure 2.3", 66) + "<h1>EKF: Figure 2.3, and real robots</h1>\n" +
                     criteria_table(all_criteria(report)) + std::string(kFigure) + "<p>Seeds 1 to " +
                     std::to_string(report.seeds) + ".</p>\n" + figure_table(report);
  html += kRealData;
  if (!report.real_data)
    return html + "<p>Not run: " + xml_text(report.real_data_missing) + ".</p></body></html>\n";
  html += parameters(*report.real_data) + real_data_table(*report.real_data) +
          "<p>MRCLAM: means over seeds 1 to " + std::to_string(report.real_data->seeds) + ".</p>\n" +
          walk_table(*report.real_data) + pictures(*report.real_data) + logs_used(*report.real_data);
  return html + "</body></html>\n";
}

}  // namespace bw
