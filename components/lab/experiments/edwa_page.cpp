// The page of edwa_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/edwa_figures.hpp"
#include "components/lab/experiments/edwa_report.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::Table;

constexpr std::string_view kAbout =
    "<h2>E3 and E4: robots among robots</h2>\n"
    "<p>A robot over 16 m from rest among robots that plan for themselves; radius 0.3 m, 1 m/s, 0.35 rad/s, "
    "1 m/s<sup>2</sup>, one command every 0.25 s.</p>\n";

constexpr std::string_view kTable =
    "<h2>Table 3.2</h2>\n"
    "<p>Average passing velocity [m/s]. Means are over the runs that reached the goal: where most DWA runs end in "
    "contact, the mean is that of the easy ones. Gain: over DWA-DWA, on the seeds that both reached.</p>\n";

std::string top(const EdwaTable& table, std::size_t seeds) {
  return page::first_screen(
      {.title = "EDWA: Figures 3.3 and 3.4, Table 3.2",
       .about =
           "What the dissertation publishes of its enhanced dynamic window approach in simulation (section 3.1), "
           "beside what is measured here over " +
           std::to_string(seeds) + " seeds.",
       .judged = "EDWA by the published setting",
       .criteria = table.criteria,
       .not_judged = {"Contacts of DWA: plain DWA takes moving robots as standing; counted, not judged.",
                      "Other readings of the source, and EDWA as it drives here: at the end of the page.",
                      "Figure 3.5, the drives of a real robot: pictures without figures."},
       .tuned = tuned_to_published("edwa")});
}

std::string rows_table(const EdwaTable& table) {
  Table html({"scene", "pairing", "published [m/s]", "mean [m/s]", "sd [m/s]", "runs", "reached", "contacts",
              "timeouts", "gain [m/s]", "mean largest δmin", "lowest v [m/s]"});
  for (const EdwaRow& row : table.rows) {
    html.row({xml_text(edwa_scene_name(row.scene)), to_string(row.pairing), fixed(row.published, 4),
              fixed(row.mean, 3), fixed(row.sd, 3), std::to_string(row.runs.size()),
              std::to_string(row.success), std::to_string(row.contacts), std::to_string(row.timeouts),
              fixed(row.gain_on_same_seeds, 3), fixed(row.mean_max_delta, 3), fixed(row.lowest_v, 2)});
  }
  return html.html();
}

std::string variants_table(const std::vector<EdwaResult>& results) {
  std::vector<std::string> headings = {"scene", "pairing", "published"};
  for (const EdwaResult& result : results) headings.push_back(result.variant.name);
  Table html(std::move(headings));
  for (std::size_t i = 0; i < results[0].table.rows.size(); ++i) {
    const EdwaRow& row = results[0].table.rows[i];
    std::vector<std::string> cells = {xml_text(edwa_scene_name(row.scene)), to_string(row.pairing),
                                      fixed(row.published, 3)};
    for (const EdwaResult& result : results) {
      const EdwaRow& other = result.table.rows.at(i);
      cells.push_back(fixed(other.mean, 3) + " (" + std::to_string(other.success) + ", " +
                      std::to_string(other.contacts) + ")");
    }
    html.row(cells);
  }
  return html.html();
}

std::string other_readings(const std::vector<EdwaResult>& results) {
  if (results.size() < 2) return "";
  std::string html =
      "<h2>Other readings</h2>\n<p>Mean [m/s] (runs that reached the goal, contacts).</p>\n<ul>\n";
  for (const EdwaResult& result : results)
    html +=
        "<li><b>" + xml_text(result.variant.name) + "</b>: " + xml_text(result.variant.meaning) + "</li>\n";
  return html + "</ul>\n" + variants_table(results);
}

}  // namespace

std::string edwa_page(const std::vector<EdwaResult>& results) {
  const EdwaTable& table = results.at(0).table;
  return page::opening("EDWA: Figures 3.3 and 3.4, Table 3.2", 70) +
         top(table, table.rows.at(0).runs.size()) + std::string(kAbout) + edwa_ways(table) +
         edwa_courses(table) + std::string(kTable) + edwa_velocities(table) + rows_table(table) +
         other_readings(results) + page::closing();
}

}  // namespace bw
