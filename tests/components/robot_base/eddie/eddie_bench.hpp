// The driver on a cable whose other end is a board that answers from a list.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "components/robot_base/eddie/eddie.hpp"
#include "tests/components/robot_base/eddie_robot.hpp"
#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::eddie {

inline EddieOptions options_with_rangers() {
  EddieOptions options;
  options.sonar_pins = {0, 1};
  options.sonar_frames = {"sonar_left", "sonar_right"};
  options.infrared_channels = {1, 2};
  options.infrared_frames = {"infrared_left", "infrared_right"};
  return options;
}

class Bench {
 public:
  explicit Bench(const EddieOptions& options = options_with_rangers(), const Robot& robot = eddie_robot())
      : eddie(options, robot, std::make_unique<ScriptedLink>(wire)) {}

  /// 10 ms. A request is answered before the next look, unless the board is silent.
  Readings step(const WheelSpeeds& wheels = {}) {
    now = now + Duration::milliseconds(10);
    Readings readings = eddie.poll(now);
    took = eddie.command(now, wheels);
    for (const EncoderCounts& one : readings.counts) counts.push_back(one);
    for (const RangeReading& one : readings.ranges) ranges.push_back(one);
    if (readings.battery) battery = readings.battery;
    for (const Bytes& bytes : std::exchange(wire.from_host, {})) {
      const std::string line(bytes.begin(), bytes.end());
      sent.push_back(line);
      if (!is_silent) wire.put(answer(line));
    }
    return readings;
  }
  Readings steps(int count, const WheelSpeeds& wheels = {}) {
    Readings readings;
    for (int i = 0; i < count; ++i) readings = step(wheels);
    return readings;
  }
  /// Until the start is over: 80 ms, and nine requests of 10 ms.
  void start() {
    steps(20);
    ASSERT_TRUE(took);
    sent.clear();
  }
  std::string answer(const std::string& line) {
    if (line == "VERB 1\r") tells_reasons = true;
    if (line == "VERB\r") return tells_reasons ? "ERROR - Too few parameters\r" : "ERROR\r";
    const std::string word = line.substr(0, line.find_first_of(" \r"));
    const auto found = answers.find(word);
    return found == answers.end() ? "ERROR - Invalid command\r" : found->second;
  }

  std::map<std::string, std::string> answers = {{"STOP", "\r"},
                                                {"VERB", "\r"},
                                                {"VER", "0014\r"},
                                                {"HWVER", "0003\r"},
                                                {"WATCH", "\r"},
                                                {"ACC", "\r"},
                                                {"SPNG", "\r"},
                                                {"GOSPD", "\r"},
                                                {"DIST", "00000000 00000000\r"},
                                                {"ADC", "333 1D5 000 000 000 000 000 BF6\r"},
                                                {"PING", "3E8 000\r"}};
  ScriptedLink::Wire wire;
  Eddie eddie;
  Time now = Time::seconds(50.0);
  bool took = false, is_silent = false;
  bool tells_reasons = false;  ///< by VERB 1, until the board loses its power
  std::vector<std::string> sent;
  std::vector<EncoderCounts> counts;
  std::vector<RangeReading> ranges;
  std::optional<BatteryReading> battery;
};

}  // namespace bw::eddie
