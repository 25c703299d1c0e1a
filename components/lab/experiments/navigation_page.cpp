// The report of navigation_report.hpp.
#include <fmt/format.h>

#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/first_screen.hpp"
#include "components/lab/experiments/navigation_report.hpp"

namespace bw {
namespace {

constexpr std::string_view kAbout =
    "The source drove Eddie with EDWA among people (Figure 3.5) and QBot 2e with EKF, A* and ETEB in a corridor "
    "(section 3.4), and shows pictures and videos: **no number is published**. So asked is what they show, the goal "
    "without a contact. Here both robots cross the hallway of E6, with three walkers who react, by their own "
    "senses: encoders, gyro, compass and receiver through the EKF, people and obstacles by the laser, A*, and the local "
    "planner. ";
constexpr std::string_view kEmulated =
    "The bases and the laser are emulated down to the bytes of their protocols, so that the drivers of the real ones drive.";
constexpr std::string_view kSimulated =
    "The world turns the wheels and makes the scans; no protocol of a real base is between.";

report::Interval interval(const Spread& spread) { return {spread.mean, spread.low, spread.high}; }

std::string planner_of(const NavigationPair& pair) {
  return pair.planner + (pair.as_published ? " as published" : "");
}

report::Table rows_table(const NavigationResults& results) {
  report::Table table({"robot", "planner", "hallway", "in the source", "success", "reached", "contacts",
                       "of them at speed", "time [s]", "way [m]", "closest person [m]", "largest CI",
                       "pose, rms [m]"});
  for (const NavigationRow& row : navigation_rows(results)) {
    const NavigationPair& pair = navigation_pairs()[row.pair];
    table.row({pair.robot, planner_of(pair), row.hallway, pair.published,
               fmt::format("{} of {}", row.successes, row.drives), row.reached, row.contacts,
               row.contacts_at_speed, interval(row.time), interval(row.path_length),
               interval(row.closest_person), interval(row.max_collision_index),
               interval(row.localization_rms)});
  }
  return table;
}

std::vector<std::string> failed_drives(const NavigationResults& results) {
  std::vector<std::string> failed;
  for (const NavigationDrive& drive : results.drives) {
    if (drive.succeeded()) continue;
    const NavigationPair& pair = navigation_pairs()[drive.pair];
    std::string name =
        fmt::format("{}, {}, {} hallway, seed {}", pair.robot, planner_of(pair), drive.hallway, drive.seed);
    if (!drive.page.empty()) name = fmt::format("[{}]({})", name, drive.page);
    failed.push_back(fmt::format("{}: {}, {} contacts, {} of them while it moved", name,
                                 drive.reached ? "reached" : "not reached (" + drive.reason + ")",
                                 drive.contacts, drive.contacts_at_speed));
  }
  return failed;
}

}  // namespace

report::Document navigation_page(const NavigationResults& results,
                                 const std::vector<report::Figure>& figures) {
  report::Document document = begin_report(
      {.title = "Eddie and QBot 2e among people",
       .about = std::string(kAbout) + std::string(results.emulated ? kEmulated : kSimulated),
       .judged = "every drive reaches its goal without a contact",
       .criteria = navigation_criteria(results, kNavigationHallway),
       .not_judged =
           {"Eddie with ETEB and QBot 2e with PTEB were not driven in the source.",
            "Judged is EDWA as it drives by default here, led by the plan (dwa/theory.md 5.9). As it was published, by heading, distance and "
            "speed alone (dwa/theory.md 5.4), it is driven too and decides nothing.",
            "Places, people and lengths of the source's drives are not published; its pictures show one to a few people. "
            "Judged is the hallway with three walkers. With six (\"full\") the same is only reported: that this is harder than "
            "what the source shows was seen in the first drives, before it was decided what to judge."},
       .tuned = tuned_to_published("navigation")});
  document.heading("All drives")
      .text(
          "Means, beside them the 5 % and 95 % quantiles over the seeds; time and way of drives that reached the goal.")
      .table(rows_table(results))
      .text("The same asked in the full hallway, which decides nothing:")
      .table(criteria_table(navigation_criteria(results, "full")));
  for (const report::Figure& figure : figures) document.figure(figure);
  const std::vector<std::string> failed = failed_drives(results);
  if (!failed.empty())
    document.heading("Drives that failed").list("Those with a link can be played.", failed);
  return document;
}

}  // namespace bw
