// Which processes fail when, and how a drive is judged: all by numbers made for it.
#include <gmock/gmock.h>

#include "components/lab/battery/injection_judge.hpp"
#include "components/lab/battery/injection_plan.hpp"

namespace bw {
namespace {

using testing::HasSubstr;

const InjectionPlan kPlan{.processes = {{.name = "planning", .component = "local_planner"},
                                        {.name = "base", .component = "robot_base", .leaks = false}}};

TEST(InjectionPlan, IsSeededAndKeepsItsDistances) {
  const auto one = injections_of(kPlan, 7, 40);
  ASSERT_EQ(one.size(), 40U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double slot = kPlan.first + kPlan.apart * static_cast<double>(i);
    EXPECT_GE(one[i].at, slot);
    EXPECT_LT(one[i].at, slot + kPlan.within);
    EXPECT_FALSE(one[i].process == "base" && one[i].kind == "process_leaks");
    EXPECT_EQ(one[i].at, injections_of(kPlan, 7, 40)[i].at);
  }
  for (const char* kind : {"process_killed", "process_stopped", "process_spins", "process_leaks"})
    EXPECT_THAT(one, testing::Contains(testing::Field(&Injection::kind, kind)));
  EXPECT_NE(one[0].at, injections_of(kPlan, 8, 1)[0].at);
}

TEST(InjectionPlan, IsASectionOfFaults) {
  EXPECT_EQ(faults_text({{"process_killed", "planning", 6.5}, {"process_spins", "base", 16.0}}, kPlan),
            "f0: {kind: process_killed, of: local_planner, from: 6.500s, for: 5s}\n"
            "f1: {kind: process_spins, of: robot_base, from: 16.000s, for: 5s}\n");
}

const InjectedProcesses kProcesses{.commander = "planning", .base = "base"};

/// At 0.5 m/s, commanded at 10 Hz; the last command at 10 s, told at 50 Hz. The wheels are told to brake after `frame`, and do so
/// with 1 m/s^2; commands and motion come again at 12 s.
InjectedDrive lost_at_10s(double frame) {
  InjectedDrive drive;
  drive.begun = {{10.02, {"process_killed", "planning", 10.0}}};
  const auto speed = [&](double t) {
    if (t >= 12.0) return std::min(0.5, t - 12.0);
    return t < 10.0 + frame ? 0.5 : std::max(0.0, 0.5 - (t - 10.0 - frame));
  };
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.02 * i;
    drive.truth.push_back({t, speed(t)});
    drive.told.push_back({t, speed(t)});
    if (i % 5 == 0 && (t < 10.001 || t > 11.9)) drive.commands.push_back(t);
  }
  drive.reached = true;
  return drive;
}

TEST(InjectionJudge, TellsStopFrameStandstillAndTheWayOn) {
  const auto judged = judge(lost_at_10s(0.21), kProcesses);
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_NEAR(judged[0].speed, 0.5, 1e-9);
  EXPECT_NEAR(*judged[0].stop_frame, 0.24, 0.021);  // 0.02 m/s slower
  EXPECT_NEAR(*judged[0].standing, 0.69, 0.021);
  EXPECT_NEAR(*judged[0].allowed, -0.02 + 0.25 + 0.5 + 0.1, 1e-9);
  EXPECT_NEAR(*judged[0].again, 2.1, 0.05);
  EXPECT_EQ(judged[0].trouble, "");
}

TEST(InjectionJudge, ALateStopFrameIsTrouble) {
  EXPECT_THAT(judge(lost_at_10s(0.3), kProcesses)[0].trouble, HasSubstr("stop frame 3"));
}

TEST(InjectionJudge, ARobotThatDrivesOnWithoutCommandsIsTrouble) {
  InjectedDrive drive = lost_at_10s(0.2);
  for (auto& [t, v] : drive.truth) v = 0.5;
  for (auto& [t, v] : drive.told) v = 0.5;
  EXPECT_NE(judge(drive, kProcesses)[0].trouble, "");
}

// Back before anything was too old: nobody had to stop.
TEST(InjectionJudge, OneThatIsBackInTimeStopsNobody) {
  InjectedDrive drive = lost_at_10s(0.2);
  drive.commands.clear();
  for (int i = 0; i < 200; ++i) drive.commands.push_back(0.1 * i);
  for (auto& [t, v] : drive.truth) v = 0.5;
  for (auto& [t, v] : drive.told) v = 0.5;
  EXPECT_EQ(judge(drive, kProcesses)[0].trouble, "");
  EXPECT_FALSE(judge(drive, kProcesses)[0].stop_frame);
}

// Who gains speed until what he goes by is old brakes from there.
TEST(InjectionJudge, TheSpeedIsTheHighestBeforeItIsOld) {
  InjectedDrive drive = lost_at_10s(0.21);
  for (auto& [t, v] : drive.truth) {
    if (t > 10.1 && t < 10.2) v = 0.6;
  }
  EXPECT_NEAR(*judge(drive, kProcesses)[0].allowed, -0.02 + 0.25 + 0.6 + 0.1, 1e-9);
}

// Another process: its pose grows old, and the planner stops.
TEST(InjectionJudge, OfAnotherProcessThePoseCounts) {
  InjectedDrive drive = lost_at_10s(0.5);
  drive.begun.front().injection.process = "rest";
  drive.poses = drive.commands;
  const auto judged = judge(drive, kProcesses);
  EXPECT_FALSE(judged[0].stop_frame);
  EXPECT_NEAR(*judged[0].allowed, -0.02 + 0.7 + 0.5 + 0.1, 1e-9);
  EXPECT_NEAR(*judged[0].standing, 0.98, 0.021);
  EXPECT_EQ(judged[0].trouble, "");
}

// The base itself: nobody tells the wheels anything for two seconds, and what is beyond it brakes.
TEST(InjectionJudge, OfTheBaseWhatTheWheelsAreToldCounts) {
  InjectedDrive drive = lost_at_10s(0.2);
  drive.begun.front().injection.process = "base";
  std::erase_if(drive.told, [](const auto& told) { return told.t > 10.001 && told.t < 12.0; });
  const auto judged = judge(drive, kProcesses);
  EXPECT_FALSE(judged[0].stop_frame);
  EXPECT_NEAR(*judged[0].allowed, -0.02 + 0.25 + 0.5 + 0.1, 1e-9);
  EXPECT_EQ(judged[0].trouble, "");
  for (auto& [t, v] : drive.truth) v = 0.5;
  EXPECT_THAT(judge(drive, kProcesses)[0].trouble, HasSubstr("did not stand"));
}

}  // namespace
}  // namespace bw
