// The hallway in real time through the pseudo-terminals of emulated bases and of an emulated laser, beside
// the simulated driver's drives of the same seeds in lock-step, which have neither cable nor firmware.
//
// One drive over 6 m, where nobody walks; BANDWAGON_DRIVES=20 drives the whole hallway with seeds 1 to 20,
// each base in one process and in three:
//   BANDWAGON_DRIVES=20 build/release/bin/test_emulated_drives
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

const std::string kSource = BANDWAGON_SOURCE_DIR;
const std::string kGraph = kSource + "/config/graphs/hallway.yaml";

int drives_asked_for() {
  const char* asked = std::getenv("BANDWAGON_DRIVES");
  return asked == nullptr ? 0 : std::atoi(asked);
}

struct Drive {
  std::string robot;
  std::string how;  ///< simulated, one process, three processes
  int seed = 1;
};

std::vector<std::string> arguments(const Drive& drive) {
  std::vector<std::string> list = {"--set",  "robot=" + kSource + "/config/robots/" + drive.robot + ".yaml",
                                   "--seed", std::to_string(drive.seed),
                                   "--for",  "240"};
  const auto add = [&](std::initializer_list<std::string> more) { list.insert(list.end(), more); };
  if (drives_asked_for() == 0)
    add({"--set", "navigator.goal.x=7.0", "--set", "world.people.social.walkers=[]"});
  if (drive.how == "simulated")
    add({"--set", "robot.base.driver=simulated", "--set", "robot.laser.driver=none", "--clock", "lockstep"});
  else
    add({"--emulate"});
  return list;
}

/// The score card; null when there is none.
nlohmann::json card_of(const Drive& drive) {
  const Folder folder;
  std::vector<std::string> command = {BANDWAGON_PROGRAM, "run", kGraph};
  std::filesystem::path card = folder / "card.json";
  if (drive.how == "three processes") {
    command = {BANDWAGON_PROGRAM, "launch", kGraph, "--logs", folder / ""};
    card = folder / "rest.json";
  }
  for (const std::string& argument : arguments(drive)) command.push_back(argument);
  if (drive.how != "three processes") command.insert(command.end(), {"--json", card.string()});
  const Outcome outcome = run_to_end(command, std::chrono::seconds(280));
  std::ifstream file(card);
  if (!file)
    ADD_FAILURE() << drive.robot << ", " << drive.how << ", seed " << drive.seed << ":\n" << outcome.err;
  return file ? nlohmann::json::parse(file) : nlohmann::json();
}

struct Tally {
  int reached = 0;
  int untouched = 0;  ///< reached, and nobody was touched
};

void print(const Drive& drive, const nlohmann::json& card, Tally& tally) {
  if (card.is_null()) return;
  const bool reached = card.value("reached", false);
  const int contacts = card.value("collisions", -1);
  const auto number = [&](const char* key) {
    return card.contains(key) && card[key].is_number() ? card[key].get<double>() : -1.0;
  };
  std::printf("%-7s %-16s %4d  %-7s %8d  %6.1f  %11.2f\n", drive.robot.c_str(), drive.how.c_str(), drive.seed,
              reached ? "reached" : "-", contacts, number("time_to_goal_s"), number("min_distance_m"));
  std::fflush(stdout);
  tally.reached += reached ? 1 : 0;
  tally.untouched += reached && contacts == 0 ? 1 : 0;
}

/// Whether somebody who walks touches a robot is of the scene and the planner: the simulated driver's drives
/// stand beside for that.
TEST(EmulatedDrives, ReachTheGoal) {
  const int asked = drives_asked_for();
  const int count = std::max(asked, 1);
  std::vector<std::string> robots = {"qbot2e"};
  std::vector<std::string> setups = {"simulated", "one process"};
  if (asked > 0) robots.emplace_back("eddie");
  if (asked > 0) setups.emplace_back("three processes");
  std::printf("robot   driver           seed  goal    contacts  time s  closest m\n");
  for (const std::string& robot : robots) {
    for (const std::string& how : setups) {
      Tally tally;
      for (int seed = 1; seed <= count; ++seed) {
        const Drive drive{robot, how, seed};
        print(drive, card_of(drive), tally);
      }
      std::printf("%-7s %-16s %d of %d reached, %d of them without any contact\n", robot.c_str(), how.c_str(),
                  tally.reached, count, tally.untouched);
      EXPECT_EQ(tally.reached, count) << robot << ", " << how;
    }
  }
}

}  // namespace
}  // namespace bw::test
