#include "components/lab/failures/failure_album.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::HasSubstr;

RunRecording failed_drive() {
  RunRecording drive;
  drive.robot = Footprint{0.3, {}};
  for (int i = 0; i <= 20; ++i)
    drive.moments.push_back(
        {.time = 0.1 * i, .X_MB = {0.1 * i, 0.0, 0.0}, .people = {{4, {2.0, 0.5}, {0.0, 0.0}, 0.3}}});
  return drive;
}

JudgedContact contact(double time, bool at_speed) {
  JudgedContact judged;
  judged.record.time = time;
  judged.record.person = 4;
  judged.record.at_speed = at_speed;
  return judged;
}

TEST(FailureAlbum, TheDecidingContactIsTheFirst) {
  FailedDrive drive{.title = "a", .contacts = {contact(1.0, false), contact(2.0, true)}};
  EXPECT_EQ(deciding_contact(drive)->record.time, 1.0);
  drive.contacts.clear();
  EXPECT_FALSE(deciding_contact(drive).has_value()) << "something else made it fail";
}

TEST(FailureAlbum, WritesOneReportUpToItsNumber) {
  nlohmann::ordered_json report;
  std::filesystem::path written;
  FailureAlbum album(
      "folder",
      [&](const report::Document& document, const std::filesystem::path& html) {
        report = document.json();
        written = html;
      },
      2);
  album.add({.title = "first [& only]", .outcome = "late"}, failed_drive());
  EXPECT_FALSE(album.is_full());
  JudgedContact judged = contact(1.5, true);
  judged.is_judged = true;
  judged.verdict = {possible::Avoidance::avoidable, 0.7, 1.1, {}};
  album.add({.title = "second", .outcome = "touched", .reached = true, .contacts = {judged}}, failed_drive());
  EXPECT_TRUE(album.is_full());
  EXPECT_EQ(written, std::filesystem::path("folder/index.html"));
  ASSERT_EQ(report["blocks"].size(), 6U);  // head, causes, list, what pictures show, two pictures
  EXPECT_EQ(report["blocks"][0]["text"], "Failed drives: 2");
  EXPECT_THAT(report["blocks"][1]["text"].get<std::string>(), HasSubstr("Causes: 1 late, 1 robot_standing."));
  // One row each: what ended it, who hit whom, verdict, from when on, cause.
  EXPECT_EQ(report["blocks"][2]["rows"][0].dump(),
            R"j([1,"[first \\[& only\\]](#d1)","late","-","-","-","-","-","late","-"])j");
  EXPECT_EQ(
      report["blocks"][2]["rows"][1].dump(),
      R"j([2,"[second](#d2)","contact at 1.50 s","robot_standing, person 4","0.00, 0.00","avoidable","0.7","1.1","robot_standing","0.00"])j");
  const nlohmann::ordered_json& figure = report["blocks"][5];
  EXPECT_EQ(figure["id"], "d2");
  EXPECT_EQ(figure["title"], "2. second");
  EXPECT_THAT(figure["caption"].get<std::string>(), HasSubstr("touched; 1.50 s person 4: robot_standing"));
  EXPECT_EQ(figure["pictures"].size(), 1U);
}

}  // namespace
}  // namespace bw
