// An emergency stop button in a process of its own, /panel, pressed until a test ends the process.
#include <std_msgs/msg/bool.hpp>
#include <unistd.h>

#include "runtime/ros/node_announcement.hpp"
#include "runtime/ros/typed_topic.hpp"

int main() {
  using namespace bw;
  dds::Participant participant{{.network = dds::Network::from_environment(dds::Transport::localhost)}};
  NodeAnnouncement announcement(participant, "panel");
  const auto button =
      participant.create_writer(typed_end<std_msgs::msg::Bool>("/emergency_stop", Qos::latched()));
  announcement.add(*button);
  announcement.publish();
  std_msgs::msg::Bool pressed;
  pressed.data(true);
  std::vector<std::uint8_t> cdr;
  serialize(pressed, cdr);
  button->write(cdr);
  for (;;) pause();
}
