// The page of anticipation_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/tools/experiments/anticipation_pictures.hpp"
#include "components/tools/experiments/anticipation_report.hpp"
#include "components/tools/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::cell;
using page::criteria_table;
using page::head;

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
    "six walkers (full) or three (light). A success reaches the goal and touches nobody while it moves; "
    "times and "
    "lengths are means of drives that reached it.</p>\n"
    "<p>Judged are drives by <b>ideal senses</b>: pose, people and walls are told without error, so that "
    "planners are compared and not what they are told. Rows by <b>own senses</b> are the whole robot: wheels, "
    "gyro, compass and receiver through the EKF, people and obstacles by the laser; the planners by their "
    "defaults, ten seeds. They are reported, not judged.</p>\n";

std::string crossing_rows(const std::vector<CrossingResult>& results) {
  std::string html = head({"planner", "published", "behind A", "behind B", "success", "contacts",
                           "largest CI, mean", "largest CI", "clearance [m], mean", "time [s]"});
  for (const CrossingResult& result : results) {
    const CrossingSummary s = summarize(result);
    const bool is_teb = result.entry.planner.starts_with("teb");
    html += "<tr>" + cell(xml_text(result.entry.label)) + cell(is_teb ? "in front" : "behind") +
            cell(fixed(s.share_behind_a, 3)) + cell(fixed(s.share_behind_b, 3)) +
            cell(std::to_string(s.successes) + " of " + std::to_string(s.runs)) +
            cell(std::to_string(s.contacts)) + cell(fixed(s.mean_max_collision_index, 3)) +
            cell(fixed(s.max_collision_index, 3)) + cell(fixed(s.mean_min_clearance, 3)) +
            cell(fixed(s.mean_time, 2)) + "</tr>\n";
  }
  return html + "</table>\n";
}

std::string optional_figure(const std::optional<double>& value) { return value ? fixed(*value, 2) : "–"; }

std::string hallway_rows_table(const std::vector<HallwayRow>& rows) {
  std::string html =
      head({"hallway", "senses", "people", "planner", "success", "contacts", "at speed", "largest CI, median",
            "seeds below 0.54", "time above 0.54", "time above 0.14", "time [s]", "way [m]"});
  for (const HallwayRow& row : rows) {
    html += "<tr>" + cell(row.episode) + cell(row.own_senses ? "own" : "ideal") +
            cell(row.people_react ? "react" : "do not react") + cell(xml_text(row.planner)) +
            cell(std::to_string(row.successes) + " of " + std::to_string(row.drives)) +
            cell(std::to_string(row.contacts)) + cell(std::to_string(row.contacts_at_speed)) +
            cell(fixed(row.median_max_collision_index, 3)) + cell(fixed(row.share_of_seeds_below_0_54, 2)) +
            cell(fixed(row.mean_share_above_0_54, 3)) + cell(fixed(row.mean_share_above_0_14, 3)) +
            cell(optional_figure(row.mean_time)) + cell(optional_figure(row.mean_path_length)) + "</tr>\n";
  }
  return html + "</table>\n";
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

}  // namespace

std::string anticipation_page(const AnticipationResults& results) {
  const std::string title = results.subject == "eteb" ? "PTEB and ETEB" : "PTEB";
  std::string html = page::opening(title, 72) + "<h1>" + title + "</h1>\n";
  html += criteria_table(anticipation_criteria(results));
  html += std::string(kCrossing) + crossing_rows(results.crossing);
  if (!results.crossing.empty() && !results.crossing.front().runs.empty()) {
    html += "<p>First seed; numbers and dots every second.</p>\n" +
            crossing_picture(results.crossing, results.geometry, 0);
  }
  html += "<h3>At the places first proposed</h3>\n" + crossing_rows(results.proposed);
  html += std::string(kHallway) + hallway_rows_table(hallway_rows(results.hallway)) +
          failed_drives(results.hallway);
  for (const bool react : {true, false}) {
    for (const char* episode : {"light", "full"}) {
      html += std::string("<h3>Largest collision index of every seed, ideal senses: ") + episode +
              ", people " + (react ? "react" : "do not react") + "</h3>\n" +
              index_picture(results.hallway, episode, react);
    }
  }
  html +=
      "<h2>The same asked of the planners as published</h2>\n" + criteria_table(published_criteria(results));
  return html + "</body></html>\n";
}

}  // namespace bw
