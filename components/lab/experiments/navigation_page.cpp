// The page of navigation_report.hpp.
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/navigation_report.hpp"
#include "components/lab/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::sensible;
using page::Table;

constexpr std::string_view kAbout =
    "The source drove Eddie with EDWA among people (Figure 3.5) and QBot 2e with EKF, A* and ETEB in a corridor "
    "(section 3.4), and shows pictures and videos: <b>no number is published</b>. So asked is what they show, the goal "
    "without a contact. Here both robots cross the hallway of E6, with three walkers who react, by their own "
    "senses: encoders, gyro, compass and receiver through the EKF, people and obstacles by the laser, A*, and the local "
    "planner. ";
constexpr std::string_view kEmulated =
    "The bases and the laser are emulated down to the bytes of their protocols, so that the drivers of the real ones drive.";
constexpr std::string_view kSimulated =
    "The world turns the wheels and makes the scans; no protocol of a real base is between.";

std::string in_words(const Spread& spread) {
  return sensible(spread.mean) + " (" + sensible(spread.low) + " to " + sensible(spread.high) + ")";
}

std::string planner_of(const NavigationPair& pair) {
  return pair.planner + (pair.as_published ? " as published" : "");
}

std::string rows_table(const NavigationResults& results) {
  Table table({"robot", "planner", "hallway", "in the source", "success", "reached", "contacts",
               "of them at speed", "time [s]", "way [m]", "closest person [m]", "largest CI",
               "pose, rms [m]"});
  for (const NavigationRow& row : navigation_rows(results)) {
    const NavigationPair& pair = navigation_pairs()[row.pair];
    table.row({xml_text(pair.robot), planner_of(pair), row.hallway, xml_text(pair.published),
               std::to_string(row.successes) + " of " + std::to_string(row.drives),
               std::to_string(row.reached), std::to_string(row.contacts),
               std::to_string(row.contacts_at_speed), in_words(row.time), in_words(row.path_length),
               in_words(row.closest_person), in_words(row.max_collision_index),
               in_words(row.localization_rms)});
  }
  return table.html();
}

std::string failed_drives(const NavigationResults& results) {
  std::string html;
  for (const NavigationDrive& drive : results.drives) {
    if (drive.succeeded()) continue;
    const NavigationPair& pair = navigation_pairs()[drive.pair];
    const std::string name = xml_text(pair.robot + ", " + planner_of(pair) + ", " + drive.hallway +
                                      " hallway, seed " + std::to_string(drive.seed));
    html += "<li>" +
            (drive.page.empty() ? name : "<a href=\"" + xml_text(drive.page) + "\">" + name + "</a>") + ": " +
            (drive.reached ? "reached, " : "not reached (" + xml_text(drive.reason) + "), ") +
            std::to_string(drive.contacts) + " contacts, " + std::to_string(drive.contacts_at_speed) +
            " of them while it moved</li>\n";
  }
  return html.empty() ? ""
                      : "<h2>Drives that failed</h2>\n<p>Those with a link can be played.</p>\n<ul>\n" +
                            html + "</ul>\n";
}

}  // namespace

std::string navigation_page(const NavigationResults& results, const std::string& figures) {
  const page::FirstScreen screen{
      .title = "Eddie and QBot 2e among people",
      .about = std::string(kAbout) + std::string(results.emulated ? kEmulated : kSimulated),
      .judged = "every drive reaches its goal without a contact",
      .criteria = navigation_criteria(results, kNavigationHallway),
      .not_judged =
          {"Eddie with ETEB and QBot 2e with PTEB were not driven in the source.",
           "Judged is EDWA as it drives by default here, led by the plan (book 5.9). As it was published, by heading, distance and "
           "speed alone (book 5.4), it is driven too and decides nothing.",
           "Places, people and lengths of the source's drives are not published; its pictures show one to a few people. "
           "Judged is the hallway with three walkers. With six (\"full\") the same is only reported: that this is harder than "
           "what the source shows was seen in the first drives, before it was decided what to judge."},
      .tuned = tuned_to_published("navigation")};
  return page::opening("Eddie and QBot 2e among people", 76) + page::first_screen(screen) +
         "<h2>All drives</h2>\n<p>Means, in brackets the 5 % and 95 % quantiles over the seeds; time and way of drives that reached "
         "the goal.</p>\n" +
         rows_table(results) + "<p>The same asked in the full hallway, which decides nothing:</p>\n" +
         page::criteria_table(navigation_criteria(results, "full")) + figures + failed_drives(results) +
         page::closing();
}

}  // namespace bw
