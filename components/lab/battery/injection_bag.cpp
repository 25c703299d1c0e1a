#include "components/lab/battery/injection_bag.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/model/robot.hpp"
#include "components/program/score_bag.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {
namespace {

/// The number of fault f2: 2.
std::size_t number_of(const std::string& name) {
  std::size_t number = 0;
  if (name.size() < 2 || name.front() != 'f') throw std::runtime_error("no injection: " + name);
  std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return number;
}

void add_fault(const diagnostic_msgs::msg::DiagnosticArray& message, const std::vector<Injection>& injections,
               InjectedDrive& drive) {
  for (const auto& status : message.status()) {
    const std::size_t number = number_of(status.name());
    if (status.level() == 0 || number >= injections.size()) continue;
    const double t = from_stamp(message.header().stamp()).to_seconds();
    const auto is_known = [&](const auto& begun) { return begun.injection.at == injections[number].at; };
    if (std::ranges::none_of(drive.begun, is_known)) drive.begun.push_back({t, injections[number]});
  }
}

template <class M, class Use>
std::function<void(bag::BytesView, double)> reads(Use use) {
  return [message = M(), use](bag::BytesView bytes, double t) mutable {
    if (deserialize({bytes.data(), bytes.size()}, message)) use(message, t);
  };
}

}  // namespace

InjectedDrive read_injected_drive(const std::filesystem::path& path,
                                  const std::vector<Injection>& injections) {
  InjectedDrive drive;
  const Robot robot;
  const std::map<std::string, std::function<void(bag::BytesView, double)>> readers = {
      {"/sim/ground_truth", reads<bandwagon_msgs::msg::GroundTruth>([&](const auto& m, double) {
         drive.truth.push_back({from_stamp(m.header().stamp()).to_seconds(), m.twist().linear().x()});
       })},
      {"/sim/wheel_commands", reads<sensor_msgs::msg::JointState>([&](const auto& m, double t) {
         if (m.velocity().size() == 2)
           drive.told.push_back({t, 0.5 * robot.wheel_radius * (m.velocity()[0] + m.velocity()[1])});
       })},
      {"/faults", reads<diagnostic_msgs::msg::DiagnosticArray>(
                      [&](const auto& m, double) { add_fault(m, injections, drive); })}};
  const auto recording = bag::open_bag(path);
  const auto messages = recording->messages({});
  bag::BagMessage message;
  for (bag::Step step = messages->next(message); step != bag::Step::end; step = messages->next(message)) {
    if (step == bag::Step::damaged) throw std::runtime_error(messages->fault().what);
    const std::string& topic = recording->topics()[message.topic].name;
    const double t = message.publish_time.to_seconds();
    if (topic == "/cmd_vel_nav") drive.commands.push_back(t);
    if (topic == "/odometry/filtered") drive.poses.push_back(t);
    if (const auto reader = readers.find(topic); reader != readers.end()) reader->second(message.data, t);
  }
  std::ranges::sort(drive.begun, {}, &InjectedDrive::Begun::t);
  for (const ScoredDrive& scored : score_bag(*recording, robot.outline(), robot.limits).drives) {
    drive.reached = scored.has_goal && scored.card.reached;  // the last one's
    drive.caused_contacts +=
        static_cast<int>(std::ranges::count_if(scored.contacts, [](const JudgedContact& one) {
          return one.record.closing.who == WhoHit::robot_closing && one.record.at_speed;
        }));
  }
  return drive;
}

}  // namespace bw
