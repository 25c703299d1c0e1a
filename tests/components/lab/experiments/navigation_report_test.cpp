// What is made of the score cards of the drives on robots, and the page.
#include "components/lab/experiments/navigation_report.hpp"

#include <gmock/gmock.h>

namespace bw {
namespace {

using ::testing::HasSubstr;

nlohmann::json card(bool reached, int contacts, int at_speed = 0) {
  return {{"reached", reached},
          {"reason", reached ? "goal reached" : "time is up"},
          {"collisions", contacts},
          {"collisions_at_speed", at_speed},
          {"time_to_goal_s", 34.0},
          {"path_length_m", 18.5},
          {"closest_person_m", nullptr},
          {"max_collision_index", 0.25},
          {"localization", {{"rms_m", 0.06}}}};
}

NavigationResults results() {
  NavigationResults results;
  for (std::size_t pair = 0; pair < navigation_pairs().size(); ++pair)
    for (std::int64_t seed = 1; seed <= 2; ++seed)
      results.drives.push_back(navigation_drive(pair, "light", seed, card(true, 0)));
  return results;
}

TEST(Navigation, DrivesTheSourcesRobotsWithTheirPlanners) {
  std::vector<std::string> pairs;
  for (const NavigationPair& pair : navigation_pairs()) pairs.push_back(pair.robot + " " + pair.planner);
  EXPECT_FALSE(navigation_pairs()[0].as_published);
  EXPECT_TRUE(navigation_pairs()[1].as_published);
  EXPECT_THAT(pairs, ::testing::ElementsAre("Eddie edwa", "Eddie edwa", "Eddie eteb", "QBot 2e eteb",
                                            "QBot 2e pteb"));
}

TEST(Navigation, TakesItsFiguresFromTheCard) {
  const NavigationDrive drive = navigation_drive(1, "light", 7, card(true, 0));
  EXPECT_EQ(drive.seed, 7);
  EXPECT_EQ(drive.time, 34.0);
  EXPECT_EQ(drive.closest_person, 0.0);  // null: nobody was met
  EXPECT_EQ(drive.localization_rms, 0.06);
  EXPECT_TRUE(drive.succeeded());
  EXPECT_FALSE(navigation_drive(1, "light", 7, nlohmann::json::object()).succeeded());
}

TEST(Navigation, IsMetWhenEveryDriveReachesItsGoalWithoutAContact) {
  const std::vector<Criterion> met = navigation_criteria(results(), "light");
  ASSERT_EQ(met.size(), 4U);
  EXPECT_TRUE(all_met(met));
  for (const Criterion& c : met) EXPECT_TRUE(c.not_judged.empty());  // two seeds show what must hold of all

  NavigationResults spoilt = results();
  spoilt.drives[0] = navigation_drive(0, "light", 1, card(false, 0));
  spoilt.drives[2] = navigation_drive(1, "light", 1, card(false, 0));  // as published: decides nothing
  spoilt.drives[5] =
      navigation_drive(2, "light", 2, card(true, 1));  // a person walked into it while it stood
  const std::vector<Criterion> missed = navigation_criteria(spoilt, "light");
  EXPECT_FALSE(missed[0].met);
  EXPECT_FALSE(missed[1].met);
  EXPECT_EQ(missed[1].measured, 1.0);
  EXPECT_EQ(missed[1].asked, "2 of 2");
  EXPECT_TRUE(missed[2].met);

  // What the full hallway shows decides nothing.
  NavigationResults full = results();
  full.drives.push_back(navigation_drive(0, "full", 1, card(false, 3)));
  EXPECT_TRUE(all_met(navigation_criteria(full, kNavigationHallway)));
  EXPECT_FALSE(all_met(navigation_criteria(full, "full")));
  EXPECT_EQ(navigation_rows(full).size(), 6U);
}

TEST(NavigationPage, SaysThatNothingIsPublishedAndLinksDrivesThatFailed) {
  NavigationResults spoilt = results();
  spoilt.drives[0] = navigation_drive(0, "light", 1, card(false, 0));
  spoilt.drives[0].page = "failed/Eddie_edwa_seed_1.html";
  report::Figure path{.title = "the way"};
  path.add(report::floor_plan("map"));
  const std::string page = navigation_page(spoilt, {path}).json().dump();
  EXPECT_THAT(page, HasSubstr("no number is published"));
  EXPECT_THAT(page, HasSubstr("1 of 2"));
  EXPECT_THAT(page, HasSubstr("](failed/Eddie_edwa_seed_1.html)"));
  EXPECT_THAT(page, HasSubstr("not reached (time is up)"));
  EXPECT_THAT(page, HasSubstr("\"the way\""));
  EXPECT_THAT(navigation_page(results(), {}).json().dump(), ::testing::Not(HasSubstr("Drives that failed")));
  EXPECT_EQ(navigation_json(spoilt)["drives"][0]["page"], "failed/Eddie_edwa_seed_1.html");
  EXPECT_EQ(navigation_json(spoilt)["rows"].size(), 5U);
}

}  // namespace
}  // namespace bw
