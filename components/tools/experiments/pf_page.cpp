// The page of pf_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/tools/experiments/page_parts.hpp"
#include "components/tools/experiments/pf_report.hpp"

namespace bw {
namespace {

using page::cell;
using page::criteria_table;

constexpr std::string_view kAbout =
    "<h1>Particle filter: Table 2.1</h1>\n"
    "<p>Mean error of the position [m] over 84 s on a circle of 15 m radius at 1 m/s; 28 to 56 s lie under a "
    "roof, where only the readings of the row are received. Readings every 0.1 s, standard deviation 0.2 m "
    "and 0.2 rad; each step of the robot errs by 4 cm along, 1.2 cm across, 0.35 degrees.</p>\n";

constexpr std::string_view kRemarks =
    "<h2>What this shows, and what not</h2>\n"
    "<ul>\n"
    "<li>Published are single runs, or means of an unknown number. Length of the run, radius and times of "
    "the roof are not published; they were chosen with the table in view, after about twenty variants. "
    "Agreement shows that the figures are attainable with sensible inputs, not that the inputs were these. "
    "Evidence are the orderings.</li>\n"
    "<li>The \"encoder\" column is read as: the last fix, and wheels from there when none comes. With fixes "
    "its mean error is 0.2 sqrt(pi/2) = 0.2507 whatever the wheels do, which is the published 0.2510 and "
    "0.2479. Wheels alone from the start are the column beside it.</li>\n"
    "<li>Noise of a step is printed as 4, 1.2, 0.35 without units. Read as cm and degrees; metres and "
    "radians cannot give the published errors.</li>\n"
    "<li>The weight is printed with the exponent 0.4, most likely a lost \"2\". Gaussian weights are the "
    "default here; the printed law runs beside them, once with errors in standard deviations and once as "
    "they are. The exponent cannot be read off the table: every law gives figures of its size, and the "
    "Gaussian one is the most exact.</li>\n"
    "<li>The published step from the first row to the second (0.1098 to 0.1451) is explained by no variant: "
    "a heading with 0.2 rad adds almost nothing to fixes.</li>\n"
    "</ul>\n";

std::string rows_table(const PfTable& table) {
  std::string html =
      "<table><tr><th>under the roof</th><th>published encoder</th><th>published proposed</th>";
  for (const PfMethod method : kPfMethods) html += "<th>" + xml_text(to_string(method)) + "</th>";
  html += "</tr>\n";
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    html += "<tr>" + cell(xml_text(kPfRows[row].name)) + cell(fixed(kPfRows[row].published_encoder, 4)) +
            cell(fixed(kPfRows[row].published_proposed, 4));
    for (const PfCell& c : table.cells[row])
      html += cell(fixed(c.mean, 4) + "<br>" + fixed(c.low, 3) + " to " + fixed(c.high, 3));
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

std::string pf_page(const PfTable& table) {
  const PfExperimentOptions& o = table.options;
  return page::opening("PF: Table 2.1", 60) + std::string(kAbout) + "<p>Seeds " +
         std::to_string(o.first_seed) + " to " + std::to_string(o.last_seed) + ", " +
         std::to_string(o.particles) +
         " particles. Mean over the seeds; below it the 5 % and 95 % quantiles.</p>\n" + rows_table(table) +
         "<h2>Criteria, Gaussian weights</h2>\n" + criteria_table(table.criteria) +
         "<h2>The same asked of the printed law</h2>\n" +
         criteria_table(pf_criteria(table, PfMethod::printed)) + std::string(kRemarks) + "</body></html>\n";
}

}  // namespace bw
