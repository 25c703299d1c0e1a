// The report of anticipation_report.hpp.
#include <fmt/format.h>

#include "components/lab/experiments/anticipation_report.hpp"
#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/crossing_chart.hpp"
#include "components/lab/experiments/first_screen.hpp"
#include "components/lab/experiments/hallway_chart.hpp"

namespace bw {
namespace {

report::Document top(const AnticipationResults& results) {
  const bool with_eteb = results.subject == "eteb";
  return begin_report(
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

std::string of(int part, int whole) { return fmt::format("{} of {}", part, whole); }

report::Table crossing_rows(const std::vector<CrossingResult>& results) {
  report::Table table({"planner",
                       "published",
                       {"behind A [%]", 1},
                       {"behind B [%]", 1},
                       "success",
                       "contacts",
                       "largest CI, mean",
                       "largest CI",
                       "clearance [m], mean",
                       {"time [s]", 1}});
  for (const CrossingResult& result : results) {
    const CrossingSummary s = summarize(result);
    const bool is_teb = result.entry.planner.starts_with("teb");
    table.row({result.entry.label, is_teb ? "in front" : "behind", 100.0 * s.share_behind_a,
               100.0 * s.share_behind_b, of(s.successes, s.runs), s.contacts, s.mean_max_collision_index,
               s.max_collision_index, s.mean_min_clearance, s.mean_time});
  }
  return table;
}

report::Table hallway_rows_table(const std::vector<HallwayRow>& rows) {
  report::Table table({"planner",
                       "hallway",
                       "senses",
                       "people",
                       "success",
                       "contacts",
                       "at speed",
                       "largest CI, median",
                       {"seeds below 0.54 [%]", 0},
                       {"time above 0.54 [%]", 1},
                       {"time above 0.14 [%]", 1},
                       {"time [s]", 1},
                       {"way [m]", 1}});
  for (const HallwayRow& row : rows)
    table.row({row.planner, row.episode, row.own_senses ? "own" : "ideal",
               row.people_react ? "react" : "do not react", of(row.successes, row.drives), row.contacts,
               row.contacts_at_speed, row.median_max_collision_index, 100.0 * row.share_of_seeds_below_0_54,
               100.0 * row.mean_share_above_0_54, 100.0 * row.mean_share_above_0_14, row.mean_time,
               row.mean_path_length});
  return table;
}

std::vector<std::string> failed_drives(const std::vector<HallwayDrive>& drives) {
  std::vector<std::string> failed;
  for (const HallwayDrive& drive : drives)
    if (!drive.page.empty())
      failed.push_back(fmt::format("[{}, {}, {} senses, people {}, seed {}]({})", drive.planner,
                                   drive.episode, drive.senses(),
                                   drive.people_react ? "react" : "do not react", drive.seed, drive.page));
  return failed;
}

void add_crossing(report::Document& document, const AnticipationResults& results) {
  document.heading("E5: people who cross (Figures 3.7, 3.11)")
      .text(
          "Published, as pictures without figures: TEB passes in front of the left crossing person, PTEB and "
          "ETEB behind. Asked here: behind A in at least 0.2 more of the runs than TEB, no contact, a lower "
          "largest collision index. The robot drives from (0, 0) to (10, 0) with at most 1 m/s and 0.5 "
          "m/s²; A comes from below at x = 4, B from above at x = 6.5, both with 1 m/s and without "
          "reacting. At the places first proposed every planner that knows of motion passes behind both; so both "
          "start 1 m farther away (the one shift allowed).")
      .text(
          "Rows named published take people as standing (TEB, PTEB) or doubled, now and 1.6 s ahead (ETEB); the "
          "others meet them where they will be. A robot that takes people as standing may walk beside A until A is "
          "out of its way, and is then counted as behind: see its time.");
  if (!results.crossing.empty() && !results.crossing.front().runs.empty())
    document
        .figure(crossing_snapshots_figure(results.crossing, results.geometry,
                                          results.subject == "eteb" ? "Figures 3.7 and 3.11" : "Figure 3.7",
                                          results.crossing.front().runs.front().seed))
        .figure(crossing_paths_figure(results.crossing, results.geometry, 0));
  document.table(crossing_rows(results.crossing))
      .heading("At the places first proposed", 3)
      .table(crossing_rows(results.proposed));
}

void add_hallway(report::Document& document, const AnticipationResults& results) {
  const std::string source = results.subject == "eteb" ? "Figures 3.9 and 3.12" : "Figure 3.9";
  document.heading("E6: hallway (Figures 3.8b, 3.9, 3.12)")
      .text(
          "Published, without figures: PTEB keeps the collision index below 0.54 throughout, TEB does not; ETEB is "
          "better than PTEB. Asked here, where people react: the median of the largest index does not rise from TEB to "
          "PTEB to ETEB, and PTEB and ETEB stay below 0.54 in at least 80 % of the seeds. The whole graph in "
          "lock-step, six walkers (full) or three (light). A success reaches the goal without any contact; times and "
          "lengths are means of drives that reached it.")
      .text(
          "Judged are drives by **ideal senses**: pose, people and walls are told without error, so that "
          "planners are compared and not what they are told. Rows by **own senses** are the whole robot: wheels, "
          "gyro, compass and receiver through the EKF, people and obstacles by the laser; the planners by their "
          "defaults, ten seeds. They are reported, not judged.")
      .figure(hallway_courses_figure(results.hallway, "full", source))
      .figure(hallway_courses_figure(results.hallway, "light", source))
      .figure(hallway_largest_figure(results.hallway))
      .table(hallway_rows_table(hallway_rows(results.hallway)))
      .list("Drives that failed, to be played:", failed_drives(results.hallway));
}

}  // namespace

report::Document anticipation_page(const AnticipationResults& results) {
  report::Document document = top(results);
  add_crossing(document, results);
  add_hallway(document, results);
  const std::vector<Criterion> published = published_criteria(results);
  if (!published.empty())
    document.heading("The criteria asked of the planners as published").table(criteria_table(published));
  return document;
}

}  // namespace bw
