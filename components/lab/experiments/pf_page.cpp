// The page of pf_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/page_parts.hpp"
#include "components/lab/experiments/pf_figures.hpp"
#include "components/lab/experiments/pf_report.hpp"

namespace bw {
namespace {

using page::criteria_table;
using page::sensible;

constexpr std::string_view kAbout =
    "<h2>E2: a circle, its middle third under a roof</h2>\n"
    "<p>84 s on a circle of 15 m radius at 1 m/s; 28 to 56 s lie under a roof, where only some readings are "
    "received. Readings every 0.1 s, standard deviation 0.2 m and 0.2 rad; each step of the robot errs by 4 cm "
    "along, 1.2 cm across, 0.35 degrees.</p>\n";

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

std::string top(const PfTable& table) {
  const PfExperimentOptions& o = table.options;
  return page::first_screen(
      {.title = "The particle filter: Figure 2.5 and Table 2.1",
       .about =
           "What the dissertation publishes of its particle filter (section 2.3), beside what is measured here "
           "with " +
           std::to_string(o.particles) + " particles over seeds " + std::to_string(o.first_seed) + " to " +
           std::to_string(o.last_seed) + ".",
       .judged = "the particle filter with Gaussian weights",
       .criteria = table.criteria,
       .not_judged =
           {"The weight as printed, with the exponent 0.4: its figures stand beside the others, and its "
            "criteria below.",
            "The published step from [x, y, theta] to [x, y] (0.1098 to 0.1451 m): no variant has it."},
       .tuned = tuned_to_published("pf")});
}

std::string rows_table(const PfTable& table) {
  std::vector<std::string> headings = {"under the roof", "encoder, published [m]", "proposed, published [m]"};
  for (const PfMethod method : kPfMethods) headings.push_back(std::string(to_string(method)) + " [m]");
  page::Table html(std::move(headings));
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    std::vector<std::string> cells = {xml_text(kPfRows[row].name), fixed(kPfRows[row].published_encoder, 4),
                                      fixed(kPfRows[row].published_proposed, 4)};
    for (const PfCell& c : table.cells[row])
      cells.push_back("<b>" + sensible(c.mean) + "</b><br>" + sensible(c.low) + " to " + sensible(c.high));
    html.row(cells);
  }
  return html.html();
}

}  // namespace

std::string pf_page(const PfTable& table) {
  return page::opening("PF: Figure 2.5 and Table 2.1", 68) + top(table) + std::string(kAbout) +
         pf_ways(table) + pf_errors_over_time(table) + pf_statistics(table) +
         "<h2>Table 2.1</h2>\n<p>Mean error of the position [m]: mean over the seeds, below it 5 to 95 % of "
         "them.</p>\n" +
         rows_table(table) + std::string(kRemarks) + "<h2>The criteria asked of the printed weights</h2>\n" +
         criteria_table(pf_criteria(table, PfMethod::printed)) + page::closing();
}

}  // namespace bw
