#include "tests/interop/nav2_tree/drive.hpp"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/interop/eventually.hpp"

namespace bw::test {
namespace {

constexpr double kGoalX = 19.0, kGoalY = 0.0;
constexpr std::chrono::seconds kDriveLimit{120};
constexpr std::chrono::seconds kStopLimit{20};

std::vector<std::string> run_command(const std::string& graph, const std::vector<std::string>& options) {
  std::vector<std::string> command = {BANDWAGON_PROGRAM, "run", graph};
  command.insert(command.end(), options.begin(), options.end());
  return command;
}

int stop_process(Process& process) {
  process.signal(SIGINT);
  return process.wait(kStopLimit).value_or(-1);
}

std::string card_path(int seed) {
  return std::filesystem::temp_directory_path() / ("card_" + std::to_string(seed) + ".json");
}

std::vector<std::string> body_options(int seed, std::vector<std::string> options) {
  options.insert(options.end(), {"--seed", std::to_string(seed), "--json", card_path(seed)});
  return options;
}

}  // namespace

std::string own_folder() { return std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/nav2_tree"; }

GraphRun::GraphRun(const std::string& graph, const std::vector<std::string>& options)
    : process_(run_command(graph, options)) {}

int GraphRun::stop() { return stop_process(process_); }

bool Player::says(const std::string& line) {
  eventually([&] { return process_.out().find(line + "\n") != std::string::npos || !process_.running(); });
  return process_.out().find(line + "\n") != std::string::npos;
}

int Player::stop() { return stop_process(process_); }

Body::Body(int seed, const std::vector<std::string>& options)
    : card_(card_path(seed)), run_(own_folder() + "/body.yaml", body_options(seed, options)) {}

nlohmann::json Body::stop() {
  run_.stop();
  std::ifstream file(card_);
  return nlohmann::json::parse(file, nullptr, false);
}

std::vector<std::unique_ptr<GraphRun>> start(const StandIns& servers) {
  std::vector<std::unique_ptr<GraphRun>> runs;
  for (const std::string& graph : servers.graphs)
    runs.push_back(std::make_unique<GraphRun>(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/nav2/" +
                                              graph + ".yaml"));
  return runs;
}

Player manage(const std::vector<std::string>& nodes) {
  std::vector<std::string> command = {NAV2_MANAGER};
  command.insert(command.end(), nodes.begin(), nodes.end());
  return Player(command);
}

nlohmann::json play_tree(double x, double y) {
  Process tree({NAV2_TREE, std::to_string(x), std::to_string(y), "0", std::to_string(kDriveLimit.count()),
                "cmd_vel_nav"});
  tree.wait(kDriveLimit + kStopLimit);
  return nlohmann::json::parse(tree.out(), nullptr, false);
}

DriveReport drive_hallway(int seed, const StandIns& servers) {
  DriveReport report;
  Body body(seed);
  const std::vector<std::unique_ptr<GraphRun>> runs = start(servers);
  Player manager = manage(servers.nodes);
  if (manager.says("active")) {
    report.tree = play_tree(kGoalX, kGoalY);
  } else {
    report.trouble = "the manager says: " + manager.process().out();
  }
  report.card = body.stop();
  if (const int status = manager.stop(); status != 0)
    report.trouble += "; manager: " + manager.process().out();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (const int status = runs[i]->stop(); status != 0)
      report.trouble += "; " + servers.graphs[i] + " ended with " + std::to_string(status) + ": " +
                        runs[i]->process().err();
  }
  report.left = INFINITY;
  if (report.card.is_object() && !report.card["robot_path"].empty()) {
    const auto& last = report.card["robot_path"].back();
    report.left = std::hypot(last[1].get<double>() - kGoalX, last[2].get<double>() - kGoalY);
  }
  return report;
}

}  // namespace bw::test
