// frozen_reader TOPIC: a reader of that topic (std_msgs/String, reliable) that takes nothing. Says "ready" once it is heard of, and waits for
// its end; who started it stops it.
#include <cstdio>

#include <std_msgs/msg/string.hpp>
#include <unistd.h>

#include "tests/faults/outside_driver.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  bw::dds::Participant participant({.network = bw::dds::Network::from_environment({})});
  const auto reader = participant.create_reader(bw::test::ros_end<std_msgs::msg::String>(argv[1]), [] {});
  if (!bw::test::eventually([&] { return reader->matched_writers() > 0; })) return 1;
  std::printf("ready\n");
  std::fflush(stdout);
  for (;;) pause();
}
