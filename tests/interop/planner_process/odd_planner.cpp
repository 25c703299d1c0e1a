// A planner process that does what ODD_PLANNER says, from its third cycle on: `well` drives on at 0.5 m/s, `hang` says
// nothing more, `crash` says "out of ideas" and aborts, `nan` answers with no number, `stale` with the stamp of the cycle
// before; `refuse` ends at once, `silent` never publishes.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

#include <geometry_msgs/msg/twist_stamped.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <unistd.h>

#include "runtime/ros/notifier.hpp"
#include "runtime/ros/typed_topic.hpp"

int main() {
  const char* variable = std::getenv("ODD_PLANNER");
  const std::string kind = variable == nullptr ? "well" : variable;
  if (kind == "refuse") {
    std::cerr << "no weights\n";
    return 3;
  }
  bw::Notifier news;
  bw::dds::Participant participant(
      {.network = bw::dds::Network::from_environment(bw::dds::Transport::localhost)});
  bw::TopicReader<nav_msgs::msg::Odometry> odom(participant, "/odom", bw::Qos::latched(),
                                                [&] { news.ring(); });
  if (kind == "silent") pause();
  bw::TopicWriter<geometry_msgs::msg::TwistStamped> cmd_vel(participant, "/cmd_vel", bw::Qos::latched());
  geometry_msgs::msg::TwistStamped answer;
  for (int cycles = 0;;) {
    news.wait(std::chrono::steady_clock::now() + std::chrono::seconds(1));
    const auto message = odom.take();
    if (!message) continue;
    const bool is_odd = ++cycles > 2;
    if (is_odd && kind == "hang") pause();
    if (is_odd && kind == "crash") {
      std::cerr << "out of ideas" << std::endl;
      std::abort();
    }
    if (!is_odd || kind != "stale") answer.header().stamp(message->header().stamp());
    answer.twist().linear().x(is_odd && kind == "nan" ? std::numeric_limits<double>::quiet_NaN() : 0.5);
    cmd_vel.publish(answer);
  }
}
