// nav2_tree X Y YAW LIMIT TOPIC: plays bt_navigator for one goal in map, for LIMIT seconds at most, and hears
// the commands on TOPIC. Prints one line of JSON. Exit status 0: the tree succeeded.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include <nlohmann/json.hpp>

#include "tests/interop/eventually.hpp"
#include "tests/interop/nav2_tree/commands.hpp"
#include "tests/interop/nav2_tree/default_tree.hpp"
#include "tests/interop/nav2_tree/frames.hpp"

namespace {

using nav2::Clock;
using nlohmann::json;

constexpr std::chrono::milliseconds kLoop{10};  // bt_loop_duration
constexpr std::chrono::seconds kPoseLimit{30};  // nobody sends a goal before the robot knows where it is

constexpr std::chrono::seconds kSettling{3};

volatile std::sig_atomic_t interrupted = 0;

double seconds_since_epoch() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

json to_json(const nav2::Journal& journal) {
  json exchanges = json::array(), ends = json::array();
  for (const nav2::Exchange& e : journal.exchanges)
    exchanges.push_back({{"what", e.what}, {"at", e.at}, {"took", e.took}, {"accepted", e.accepted}});
  for (const nav2::GoalEnd& e : journal.ends) {
    ends.push_back({{"action", e.action},
                    {"at", e.at},
                    {"status", e.status},
                    {"code", e.code},
                    {"text", e.text},
                    {"was_replaced", e.was_replaced}});
  }
  return {{"exchanges", exchanges},
          {"ends", ends},
          {"preemptions", journal.preemptions},
          {"troubles", journal.troubles}};
}

/// The largest fall of speed after each of the instants, those without commands around them left out.
json dips(const std::vector<nav2::Command>& commands, const std::vector<double>& instants, double later) {
  json all = json::array();
  for (const double at : instants) all.push_back(nav2::dip(commands, at + later));
  return all;
}

class Drive {
 public:
  Drive(nav2::PoseStamped goal, std::chrono::seconds limit, const std::string& topic)
      : limit_(limit), node_("bt_navigator"), frames_(node_), commands_(node_, topic) {
    board_.goal = std::move(goal);
  }

  std::string run() {
    sleep_until(Clock::now() + kPoseLimit, [this] { return frames_.pose().has_value(); });
    if (!frames_.pose()) return "missing pose of base_link in map";
    // The node has been there for a while when its tree is loaded, as bt_navigator has when it is activated.
    tree_ = std::make_unique<nav2::DefaultTree>(node_, journal_, board_);
    if (const auto missing = tree_->missing_server()) return "missing " + *missing;
    // Servers may still be getting to know its clients; nobody sends a goal in that very moment.
    sleep_until(Clock::now() + kSettling, [] { return false; });
    journal_.start = Clock::now();
    commands_.commands.clear();
    nav2::Status status = nav2::Status::running;
    for (auto next = Clock::now(); status == nav2::Status::running; next += kLoop) {
      if (interrupted != 0 || Clock::now() - journal_.start > limit_) {
        tree_->halt();
        return "late";
      }
      status = tree_->tick();
      if (const auto age = frames_.age(seconds_since_epoch())) pose_ages_.push_back(*age);
      if (next < Clock::now()) next = Clock::now();
      sleep_until(next + kLoop, [] { return false; });
    }
    return status == nav2::Status::success ? "succeeded" : "failed";
  }

  json report(const std::string& outcome) {
    json report = to_json(journal_);
    report["outcome"] = outcome;
    report["time"] = journal_.now();
    report["recoveries"] = board_.number_recoveries;
    report["follow_path_error_code"] = board_.follow_path_error_code;
    report["compute_path_error_code"] = board_.compute_path_error_code;
    report["dips"] = dips(commands_.commands, journal_.preemptions, 0.0);
    report["dips_in_between"] = dips(commands_.commands, journal_.preemptions, 0.5);
    report["commands"] = commands_.commands.size();
    report["last_command"] = commands_.commands.empty() ? 0.0 : commands_.commands.back().speed;
    std::ranges::sort(pose_ages_);
    if (!pose_ages_.empty()) {
      report["pose_age_p50"] = pose_ages_[pose_ages_.size() / 2];
      report["pose_age_max"] = pose_ages_.back();
    }
    if (const auto pose = frames_.pose()) report["pose"] = {pose->x, pose->y, pose->yaw()};
    return report;
  }

 private:
  template <class Seen>
  void sleep_until(Clock::time_point end, Seen seen) {
    constexpr std::chrono::microseconds kPause{500};
    bw::test::poll_until(end, kPause, [&] {
      frames_.poll();
      commands_.poll(journal_);
      if (tree_) tree_->poll();
      return seen();
    });
  }

  std::chrono::seconds limit_;
  plain::Node node_;
  nav2::Journal journal_;
  nav2::Blackboard board_;
  nav2::Frames frames_;
  nav2::CommandLog commands_;
  std::unique_ptr<nav2::DefaultTree> tree_;
  std::vector<double> pose_ages_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "usage: nav2_tree X Y YAW LIMIT TOPIC\n";
    return 2;
  }
  std::signal(SIGINT, [](int) { interrupted = 1; });
  const nav2::PoseStamped goal{
      .header = {}, .pose = nav2::Pose::of(std::atof(argv[1]), std::atof(argv[2]), std::atof(argv[3]))};
  Drive drive(goal, std::chrono::seconds(std::atoi(argv[4])), argv[5]);
  const std::string outcome = drive.run();
  std::cout << drive.report(outcome).dump() << std::endl;
  return outcome == "succeeded" ? 0 : 1;
}
