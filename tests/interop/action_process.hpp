// action_graph as a child process of a test, and goals and results of nav2_msgs as each distribution has
// them, in plain CDR.
// Layouts: navigation2's branches humble and jazzy; hashes: printed by Jazzy's generator.
#pragma once

#include <csignal>
#include <string>

#include "tests/interop/plain/action_client.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {

class ActionProcess {
 public:
  explicit ActionProcess(const std::vector<std::string>& arguments) : process_(command(arguments)) {}

  Process& process() { return process_; }
  /// Its exit status.
  int stop() {
    process_.signal(SIGTERM);
    return process_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  static std::vector<std::string> command(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), ACTION_GRAPH);
    return arguments;
  }
  Process process_;
};

inline constexpr const char* kNavigateToPose = "nav2_msgs/action/NavigateToPose";
inline constexpr const char* kFollowPath = "nav2_msgs/action/FollowPath";

struct Humble {
  static constexpr const char* kName = "humble";
  static constexpr plain::GidSize kGidSize = plain::GidSize::humble;
  static plain::ActionType navigate_to_pose() { return plain::action_type(kNavigateToPose); }
  /// std_msgs/Empty, a byte.
  static void no_result(plain::CdrOut& cdr) { cdr.number(std::uint8_t{0}); }
  static void result(plain::CdrOut& cdr, std::uint16_t, const std::string&) { no_result(cdr); }
};

struct Jazzy {
  static constexpr const char* kName = "jazzy";
  static constexpr plain::GidSize kGidSize = plain::GidSize::iron_and_later;
  static plain::ActionType navigate_to_pose() {
    return plain::action_type(
        kNavigateToPose,
        plain::ActionHashes{
            .send_goal_request = "e9381f2acfe9fa8c4838a277d0cde28a93c483564827b9f13496b9c2092e4f09",
            .send_goal_response = "99f97fcbb07daf024df4b8c3f02f19ce7fa3183fcedfb76b8772a61a371a55fa",
            .get_result_request = "106d3457cf0db4c4a8d3373bab3ff6aa8ba8ad99ae6392ce9784830a7d04ac93",
            .get_result_response = "c59f178c377de5318919c00bdbf7884cb3b185acfdffceba6c9f161e0aa3cc81",
            .feedback = "9d1f6fa2eb975ce733b419ac2e97b134d8ff92b6478b6559feed9a50bdfd82b3"});
  }
  static void no_result(plain::CdrOut& cdr) { result(cdr, 0, ""); }
  static void result(plain::CdrOut& cdr, std::uint16_t code, const std::string& text) {
    cdr.number(code).text(text);
  }
};

inline void write_pose(plain::CdrOut& cdr, double x) {
  cdr.number(std::int32_t{0}).number(std::uint32_t{0}).text("map");
  for (const double value : {x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) cdr.number(value);
}

/// The same in both; `text` says what becomes of it (scripted_actions.hpp).
inline plain::Bytes navigate_goal(const std::string& text) {
  plain::CdrOut cdr;
  write_pose(cdr, 2.5);
  return cdr.text(text).bytes();
}

/// `checkers`: texts behind the name of the controller; 1 in Humble, 2 in Jazzy.
inline plain::Bytes follow_goal(const std::string& text, std::uint32_t poses, int checkers) {
  plain::CdrOut cdr;
  cdr.number(std::int32_t{0}).number(std::uint32_t{0}).text("map").number(poses);
  for (std::uint32_t i = 0; i < poses; ++i) write_pose(cdr, 0.01 * i);
  cdr.text(text);
  for (int i = 0; i < checkers; ++i) cdr.text("");
  return cdr.bytes();
}

/// The reply of get_result.
template <class Distro>
std::string result_hex(plain::GoalStatus status, std::uint16_t code = 0, const std::string& text = "") {
  plain::CdrOut cdr;
  cdr.number(static_cast<std::int8_t>(status));
  Distro::result(cdr, code, text);
  return plain::to_hex(plain::padded(cdr.bytes()));
}

}  // namespace bw::test
