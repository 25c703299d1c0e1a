#include "components/lab/failures/failure_album.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

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
  FailedDrive drive{.name = "a", .contacts = {contact(1.0, false), contact(2.0, true)}};
  EXPECT_EQ(deciding_contact(drive)->record.time, 1.0);
  drive.contacts.clear();
  EXPECT_FALSE(deciding_contact(drive).has_value()) << "something else made it fail";
}

TEST(FailureAlbum, WritesPicturesAndOnePageUpToItsNumber) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "bandwagon_failure_album";
  std::filesystem::remove_all(folder);
  FailureAlbum album(folder, 2);
  album.add({.name = "one", .title = "first & only", .outcome = "late"}, failed_drive());
  EXPECT_FALSE(album.is_full());
  JudgedContact judged = contact(1.5, true);
  judged.is_judged = true;
  judged.verdict = {possible::Avoidance::avoidable, 0.7, 1.1, {}};
  album.add({.name = "two", .title = "second", .outcome = "touched", .reached = true, .contacts = {judged}},
            failed_drive());
  EXPECT_TRUE(album.is_full());
  EXPECT_THAT(text_of(folder / "one.svg"), HasSubstr("first &amp; only"));
  EXPECT_THAT(text_of(folder / "two.svg"), HasSubstr("1.50 s person 4: robot_standing"));
  const std::string page = text_of(folder / "index.html");
  EXPECT_THAT(page, HasSubstr("Failed drives: 2"));
  EXPECT_THAT(page, HasSubstr("<img src=\"one.svg\" alt=\"first &amp; only\""));
  EXPECT_THAT(page, HasSubstr("2. second: touched<br/>1.50 s person 4: robot_standing"));
  // One row each: what ended it, who hit whom, verdict, from when on, cause.
  EXPECT_THAT(page, HasSubstr("Causes: 1 late, 1 robot_standing."));
  EXPECT_THAT(
      page, HasSubstr("<tr><td>1</td><td><a href=\"#d1\">first &amp; only</a></td><td>late</td><td>-</td>"));
  EXPECT_THAT(
      page,
      HasSubstr(
          "<td>contact at 1.50 s</td><td>robot_standing, person 4</td><td>0.00, 0.00</td><td>avoidable</td>"
          "<td>0.7</td><td>1.1</td><td>robot_standing</td><td>0.00</td>"));
  EXPECT_THAT(page, HasSubstr("<figure id=\"d2\">"));
}

}  // namespace
}  // namespace bw
