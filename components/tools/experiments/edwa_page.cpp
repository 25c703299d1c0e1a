// The page of edwa_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/tools/experiments/edwa_report.hpp"
#include "components/tools/experiments/line_plot.hpp"
#include "components/tools/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::cell;
using page::criteria_table;
using page::verdict;

constexpr std::string_view kAbout =
    "<h1>EDWA: Table 3.2</h1>\n"
    "<p>Average passing velocity [m/s] over 16 m from rest, of a robot among robots that plan for "
    "themselves; radius 0.3 m, 1 m/s, 0.35 rad/s, 1 m/s<sup>2</sup>, one command every 0.25 s. Means are "
    "over the runs that reached the goal: where most DWA runs end in contact, the mean is that of the easy "
    "ones. The published scenes are a picture only; places, margins and options were chosen with the "
    "published figures in view, so agreement shows that the figures are attainable, not that the inputs were "
    "these. Gain: over DWA-DWA, on the seeds that both reached.</p>\n";

std::string rows_table(const EdwaTable& table) {
  std::string html =
      "<table><tr><th>scene</th><th>pairing</th><th>published</th><th>mean</th><th>sd</th><th>runs</th>"
      "<th>reached</th><th>contacts</th><th>timeouts</th><th>gain</th><th>mean largest "
      "delta_min</th><th>lowest "
      "v</th></tr>\n";
  for (const EdwaRow& row : table.rows) {
    html += "<tr>" + cell(xml_text(edwa_scene_name(row.scene))) + cell(to_string(row.pairing)) +
            cell(fixed(row.published, 4)) + cell(fixed(row.mean, 4)) + cell(fixed(row.sd, 4)) +
            cell(std::to_string(row.runs.size())) + cell(std::to_string(row.success)) +
            cell(std::to_string(row.contacts)) + cell(std::to_string(row.timeouts)) +
            cell(fixed(row.gain_on_same_seeds, 4)) + cell(fixed(row.mean_max_delta, 3)) +
            cell(fixed(row.lowest_v, 2)) + "</tr>\n";
  }
  return html + "</table>\n";
}

// Course of the first seed of one scene, all pairings.
std::string course(const EdwaTable& table, int scene) {
  constexpr std::string_view kColors[] = {"#b3261e", "#1f6fb2", "#187a2f"};
  LinePlot delta{.title = std::string(edwa_scene_name(scene)), .y_label = "delta_min"};
  LinePlot speed{.title = std::string(edwa_scene_name(scene)), .y_label = "v [m/s]", .y_max = 1.2};
  for (const EdwaRow& row : table.rows) {
    if (row.scene != scene) continue;
    const std::string color(kColors[delta.curves.size() % std::size(kColors)]);
    delta.curves.push_back({to_string(row.pairing), color, {}});
    speed.curves.push_back({to_string(row.pairing), color, {}});
    for (const FloorSample& sample : row.example) {
      delta.curves.back().points.emplace_back(sample.time, delta_min(sample.gap));
      speed.curves.back().points.emplace_back(sample.time, sample.v);
    }
  }
  return to_svg(delta) + to_svg(speed);
}

std::string variants_table(const std::vector<EdwaResult>& results) {
  std::string html = "<table><tr><th>scene</th><th>pairing</th><th>published</th>";
  for (const EdwaResult& result : results) html += "<th>" + xml_text(result.variant.name) + "</th>";
  html += "</tr>\n";
  for (std::size_t i = 0; i < results[0].table.rows.size(); ++i) {
    const EdwaRow& row = results[0].table.rows[i];
    html += "<tr>" + cell(xml_text(edwa_scene_name(row.scene))) + cell(to_string(row.pairing)) +
            cell(fixed(row.published, 3));
    for (const EdwaResult& result : results) {
      const EdwaRow& other = result.table.rows.at(i);
      html += cell(fixed(other.mean, 3) + " (" + std::to_string(other.success) + ", " +
                   std::to_string(other.contacts) + ")");
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

std::string edwa_page(const std::vector<EdwaResult>& results) {
  const EdwaTable& table = results.at(0).table;
  std::string html = page::opening("EDWA: Table 3.2", 60) + std::string(kAbout) +
                     criteria_table(table.criteria) + rows_table(table);
  html +=
      "<h2>Figure 3.4</h2>\n"
      "<p>delta_min(t) = exp(-(d/3)<sup>2</sup>) of the gap d [m] to the nearest robot, and speed; first "
      "seed.</p>\n";
  for (int scene = 0; scene < kEdwaScenes; ++scene) html += course(table, scene);
  if (results.size() > 1) {
    html += "<h2>Other readings</h2>\n<p>Mean [m/s] (runs that reached the goal, contacts).</p>\n<ul>\n";
    for (const EdwaResult& result : results) {
      html +=
          "<li><b>" + xml_text(result.variant.name) + "</b>: " + xml_text(result.variant.meaning) + "</li>\n";
    }
    html += "</ul>\n" + variants_table(results);
  }
  return html + "</body></html>\n";
}

}  // namespace bw
