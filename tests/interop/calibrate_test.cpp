// `bandwagon calibrate odometry` and `bandwagon teleop` with a simulated robot in real time: prompts, one
// short straight, the file that it writes, every way to end it, and the emergency stop of a hand.
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/folder.hpp"
#include "tests/interop/on_terminal.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

const std::string kSource = BANDWAGON_SOURCE_DIR;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Calibrate : public testing::Test {
 protected:
  Calibrate() {
    std::filesystem::copy_file(kSource + "/config/robots/generic.yaml", robot_);
    before_ = text_of(robot_);
  }
  std::vector<std::string> command(const std::string& straights, const std::string& laps) const {
    return {"calibrate", "odometry", robot_.string(), "--straight", "0.5", "--straights", straights,
            "--side",    "0.5",      "--laps",        laps,         "--v", "0.5"};
  }
  void TearDown() override {
    graph_.signal(SIGINT);
    EXPECT_TRUE(graph_.wait(std::chrono::seconds(20)));
  }

  Folder folder_;
  std::filesystem::path robot_ = folder_ / "robot.yaml";
  std::string before_;
  Process graph_{{BANDWAGON_PROGRAM, "run", kSource + "/tests/interop/by_hand.yaml", "--stay"}};
};

// Encoders count 2 % too much, so that half a metre by odometry is 0.5 / 1.02 m on the floor; told so, the
// radius is 0.0762 / 1.02 = 0.07471, and what two numbers by tape measure do not tell stays.
TEST_F(Calibrate, AStraightCorrectsTheRadiusInTheFileWhenItIsToldTo) {
  OnTerminal terminal(command("1", "0"));
  ASSERT_TRUE(terminal.shows("[Enter drives, q ends]")) << terminal.out();
  terminal.press("\n");
  ASSERT_TRUE(terminal.shows("How far is it")) << terminal.out();
  terminal.press("far\n");
  ASSERT_TRUE(terminal.shows("1 to 1 numbers")) << terminal.out();
  terminal.forget();
  // Where it stopped by odometry is not exactly 0.5 m: the end of a leg is a few mm behind it.
  terminal.press("0.494\n");
  ASSERT_TRUE(terminal.shows("Write them into")) << terminal.out();
  EXPECT_EQ(text_of(robot_), before_) << "not before it is told to";
  EXPECT_THAT(terminal.out(), HasSubstr("The wheels turn at"));
  EXPECT_THAT(terminal.out(), HasSubstr("not measured")) << "separation";
  terminal.press("y\n");
  EXPECT_EQ(terminal.status(), 0) << terminal.out();
  const std::string after = text_of(robot_);
  const std::size_t at = after.find("wheel_radius: ") + 14;
  EXPECT_NEAR(std::stod(after.substr(at)), 0.0762 / 1.02, 0.0762 * 0.03);
  EXPECT_NE(after, before_);
  EXPECT_THAT(after, HasSubstr("wheel_radius_ratio: 1 "));
  EXPECT_THAT(after, HasSubstr("wheel_separation: 0.39 "));
}

TEST_F(Calibrate, EveryOtherEndWritesNothing) {
  const auto ends_by = [&](const std::string& keys, bool while_it_drives, const std::string& why) {
    OnTerminal terminal(command("1", "1"));
    ASSERT_TRUE(terminal.shows("[Enter drives, q ends]")) << terminal.out();
    if (while_it_drives) terminal.press("\n");
    terminal.press(keys);
    EXPECT_TRUE(terminal.shows(why)) << terminal.out();
    EXPECT_EQ(terminal.status(), 1);
  };
  ends_by("q\n", false, "ended by hand");
  ends_by("\x03", false, "interrupted");
  ends_by("\x03", true, "interrupted");
  ends_by("\n", true, "stopped by hand");
  EXPECT_EQ(text_of(robot_), before_);
}

// x latches the base, which says so; R and y let it drive again.
TEST_F(Calibrate, AHandStopsTheBaseForGoodAndReleasesIt) {
  OnTerminal terminal({"teleop"});
  ASSERT_TRUE(terminal.shows("standing")) << terminal.out();
  terminal.press("w");
  ASSERT_TRUE(terminal.shows("driving")) << terminal.out();
  terminal.press("x");
  ASSERT_TRUE(terminal.shows("EMERGENCY STOP")) << terminal.out();
  ASSERT_TRUE(terminal.shows("(R releases)")) << terminal.out();
  terminal.forget();
  terminal.press("R");
  terminal.press("y");
  ASSERT_TRUE(terminal.shows("released: ")) << terminal.out();
  ASSERT_TRUE(terminal.shows("standing")) << terminal.out();
  terminal.forget();
  terminal.press("w");
  ASSERT_TRUE(terminal.shows("drives on in 2 s")) << terminal.out();
  // Each press is held for 0.2 s: more of them than the pause of 2 s takes.
  for (int i = 0; i < 40 && terminal.out().find("driving") == std::string::npos; ++i) {
    terminal.forget();
    terminal.press("w");
    ASSERT_TRUE(terminal.shows("hand 0.15 m/s")) << i;
    ASSERT_TRUE(terminal.shows("hand 0.00 m/s")) << i;
  }
  EXPECT_TRUE(terminal.shows("driving"));
  terminal.press("q");
  EXPECT_EQ(terminal.status(), 0);
}

// Wheels, cable, firmware and laser as on the floor, all emulated: ends are the localization's, and nobody is
// asked for a distance. The particle filter is a centimetre or two off, so that one metre tells the radius to
// 5 %.
TEST(CalibrateByPoses, TakesTheEndsOfTheLocalization) {
  const Folder folder;
  const std::filesystem::path robot = folder / "qbot2e.yaml";
  std::filesystem::copy_file(kSource + "/config/robots/qbot2e.yaml", robot);
  Process graph{{BANDWAGON_PROGRAM, "run", kSource + "/config/graphs/robot.yaml", "--emulate", "--set",
                 "robot=" + robot.string(), "--stay"}};
  OnTerminal terminal({"calibrate", "odometry", robot.string(), "--poses", "amcl_pose", "--straight", "1",
                       "--straights", "1", "--laps", "0"});
  ASSERT_TRUE(terminal.shows("[Enter drives, q ends]")) << terminal.out() << graph.err();
  terminal.press("\n");
  ASSERT_TRUE(terminal.shows("Write them into")) << terminal.out() << graph.err();
  EXPECT_EQ(terminal.out().find("How far is it"), std::string::npos);
  const std::size_t at = terminal.out().rfind("wheel_radius: ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(terminal.out().substr(at + 14)), 0.035, 0.05 * 0.035) << terminal.out();
  terminal.press("\n");
  ASSERT_TRUE(terminal.shows("Nothing was written")) << terminal.out();
  EXPECT_EQ(terminal.status(), 0);
  graph.signal(SIGINT);
  EXPECT_TRUE(graph.wait(std::chrono::seconds(20)));
}

TEST(CalibrateAlone, WantsARobotFileOfTheUsualForm) {
  const Folder folder;
  std::ofstream(folder / "flow.yaml") << "{wheel_radius: 0.1, wheel_separation: 0.3}\n";
  const Outcome flow = run_to_end({BANDWAGON_PROGRAM, "calibrate", "odometry", folder / "flow.yaml"},
                                  std::chrono::seconds(20));
  EXPECT_EQ(flow.status, 2);
  EXPECT_THAT(flow.err, HasSubstr("there is no line `wheel_radius: VALUE`"));
  std::ofstream(folder / "wrong.yaml") << "wheel_radius: -1\n";
  const Outcome wrong = run_to_end({BANDWAGON_PROGRAM, "calibrate", "odometry", folder / "wrong.yaml"},
                                   std::chrono::seconds(20));
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("wrong.yaml:1: robot.wheel_radius = -1"));
}

}  // namespace
}  // namespace bw::test
