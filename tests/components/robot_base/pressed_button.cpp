// An emergency stop button in a process of its own, /panel, pressed until a test ends the process.
#include <std_msgs/msg/bool.hpp>
#include <unistd.h>

#include "runtime/cli/typed_topic.hpp"
#include "runtime/ros/node_announcement.hpp"

int main() {
  using namespace bw;
  dds::Participant participant{{.network = dds::Network::from_environment(dds::Transport::localhost)}};
  NodeAnnouncement announcement(participant, "panel");
  cli::TopicWriter<std_msgs::msg::Bool> button(participant, "/emergency_stop", Qos::latched());
  std_msgs::msg::Bool pressed;
  pressed.data(true);
  button.publish(pressed);
  for (;;) pause();
}
