// The page of anticipation_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/anticipation_report.hpp"
#include "components/lab/experiments/crossing_figures.hpp"
#include "components/lab/experiments/hallway_figures.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::criteria_table;
using page::sensible;
using page::Table;

constexpr std::string_view kCrossing =
    "<h2>E5: people who cross (Figures 3.7, 3.11)</h2>\n"
    "<p>Published, as pictures without figures: TEB passes in front of the left crossing person, PTEB and "
    "ETEB behind. Asked here: behind A in at least 0.2 more of the runs than TEB, no contact, a lower "
    "largest collision index. The robot drives from (0, 0) to (10, 0) with at most 1 m/s and 0.5 "
    "m/s<sup>2</sup>; A comes from below at x = 4, B from above at x = 6.5, both with 1 m/s and without "
    "reacting. At the places first proposed every planner that knows of motion passes behind both; so both "
    "start 1 m farther away (the one shift allowed).</p>\n"
    "<p>Rows named published take people as standing (TEB, PTEB) or doubled, now and 1.6 s ahead (ETEB); the "
    "others meet them where they will be. A robot that takes people as standing may walk beside A until A is "
    "out of its way, and is then counted as behind: see its time.</p>\n";

constexpr std::string_view kHallway =
    "<h2>E6: hallway (Figures 3.8b, 3.9, 3.12)</h2>\n"
    "<p>Published, without figures: PTEB keeps the collision index below 0.54 throughout, TEB does not; ETEB "
    "is "
    "better than PTEB. Asked here, where people react: the median of the largest index does not rise from "
    "TEB to "
    "PTEB to ETEB, and PTEB and ETEB stay below 0.54 in at least 80 % of the seeds. The whole graph in "
    "lock-step, "
    "six walkers (full) or three (light). A success reaches the goal without any contact; "
    "times and "
    "lengths are means of drives that reached it.</p>\n"
    "<p>Judged are drives by <b>ideal senses</b>: pose, people and walls are told without error, so that "
    "planners are compared and not what they are told. Rows by <b>own senses</b> are the whole robot: wheels, "
    "gyro, compass and receiver through the EKF, people and obstacles by the laser; the planners by their "
    "defaults, ten seeds. They are reported, not judged.</p>\n";

std::string top(const AnticipationResults& results) {
  const bool with_eteb = results.subject == "eteb";
  return page::first_screen(
      {.title = with_eteb ? "PTEB and ETEB: Figures 3.7, 3.9, 3.11 and 3.12" : "PTEB: Figures 3.7 and 3.9",
       .about =
           std::string("What the dissertation publishes, as pictures without figures, of its ") +
           (with_eteb ? "proactive and extended timed elastic bands (sections 3.2 and 3.3)"
                      : "proactive timed elastic band (section 3.2)") +
           ", beside what is measured here: who passes behind people who cross, and how near the robot comes to "
           "people in a hallway.",
       .judged = "the planners by their defaults, ideal senses",
       .criteria = anticipation_criteria(results),
       .not_judged =
           {"The planners in their published forms: driven beside the others, their criteria at the end of "
            "the page.",
            "Drives by own senses, and people who do not react: only reported.",
            "Places, times and lengths of the source's pictures: not given, so that only orderings can be "
            "compared."},
       .tuned = tuned_to_published(results.subject)});
}

std::string crossing_rows(const std::vector<CrossingResult>& results) {
  Table table({"planner", "published", "behind A [%]", "behind B [%]", "success", "contacts",
               "largest CI, mean", "largest CI", "clearance [m], mean", "time [s]"});
  for (const CrossingResult& result : results) {
    const CrossingSummary s = summarize(result);
    const bool is_teb = result.entry.planner.starts_with("teb");
    table.row({xml_text(result.entry.label), is_teb ? "in front" : "behind",
               fixed(100.0 * s.share_behind_a, 1), fixed(100.0 * s.share_behind_b, 1),
               std::to_string(s.successes) + " of " + std::to_string(s.runs), std::to_string(s.contacts),
               sensible(s.mean_max_collision_index), sensible(s.max_collision_index),
               sensible(s.mean_min_clearance), fixed(s.mean_time, 1)});
  }
  return table.html();
}

std::string optional_figure(const std::optional<double>& value) { return value ? fixed(*value, 1) : "–"; }

std::string hallway_rows_table(const std::vector<HallwayRow>& rows) {
  Table table({"planner", "hallway", "senses", "people", "success", "contacts", "at speed",
               "largest CI, median", "seeds below 0.54 [%]", "time above 0.54 [%]", "time above 0.14 [%]",
               "time [s]", "way [m]"});
  for (const HallwayRow& row : rows) {
    table.row({xml_text(row.planner), row.episode, row.own_senses ? "own" : "ideal",
               row.people_react ? "react" : "do not react",
               std::to_string(row.successes) + " of " + std::to_string(row.drives),
               std::to_string(row.contacts), std::to_string(row.contacts_at_speed),
               sensible(row.median_max_collision_index), fixed(100.0 * row.share_of_seeds_below_0_54, 0),
               fixed(100.0 * row.mean_share_above_0_54, 1), fixed(100.0 * row.mean_share_above_0_14, 1),
               optional_figure(row.mean_time), optional_figure(row.mean_path_length)});
  }
  return table.html();
}

std::string failed_drives(const std::vector<HallwayDrive>& drives) {
  std::string html;
  for (const HallwayDrive& drive : drives) {
    if (drive.page.empty()) continue;
    html += "<li><a href=\"" + xml_text(drive.page) + "\">" + xml_text(drive.planner) + ", " + drive.episode +
            ", " + drive.senses() + " senses, people " + (drive.people_react ? "react" : "do not react") +
            ", seed " + std::to_string(drive.seed) + "</a></li>\n";
  }
  return html.empty() ? "" : "<p>Drives that failed, to be played:</p>\n<ul>\n" + html + "</ul>\n";
}

std::string crossing_part(const AnticipationResults& results) {
  const bool with_eteb = results.subject == "eteb";
  std::string html(kCrossing);
  if (!results.crossing.empty() && !results.crossing.front().runs.empty()) {
    const std::uint64_t seed = results.crossing.front().runs.front().seed;
    html += crossing_snapshot_figure(snapshots_of(results.crossing, results.geometry, seed),
                                     with_eteb ? "Figures 3.7 and 3.11" : "Figure 3.7", seed) +
            crossing_ways(results.crossing, results.geometry, 0);
  }
  return html + crossing_rows(results.crossing) + "<h3>At the places first proposed</h3>\n" +
         crossing_rows(results.proposed);
}

std::string hallway_part(const AnticipationResults& results) {
  const std::string source = results.subject == "eteb" ? "Figures 3.9 and 3.12" : "Figure 3.9";
  return std::string(kHallway) + hallway_courses(results.hallway, source) +
         hallway_largest_indices(results.hallway) + hallway_rows_table(hallway_rows(results.hallway)) +
         failed_drives(results.hallway);
}

}  // namespace

std::string anticipation_page(const AnticipationResults& results) {
  const std::vector<Criterion> published = published_criteria(results);
  std::string html = page::opening(results.subject == "eteb" ? "PTEB and ETEB" : "PTEB", 76) + top(results) +
                     crossing_part(results) + hallway_part(results);
  if (!published.empty())
    html += "<h2>The criteria asked of the planners as published</h2>\n" + criteria_table(published);
  return html + page::closing();
}

}  // namespace bw
