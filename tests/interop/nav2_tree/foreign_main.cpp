// nav2_foreign_servers TOPIC: a planner_server and a controller_server that command on TOPIC, until they are
// interrupted. Prints "ready", and at its end how many plans and preemptions there were.
#include <csignal>
#include <iostream>

#include "tests/interop/eventually.hpp"
#include "tests/interop/nav2_tree/foreign_servers.hpp"
#include "tests/interop/nav2_tree/tree_nodes.hpp"

namespace {

constexpr std::chrono::milliseconds kControl{50};
volatile std::sig_atomic_t interrupted = 0;

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  plain::Node planner_node("planner_server"), controller_node("controller_server");
  nav2::Frames frames(controller_node);
  nav2::ForeignPlanner planner(planner_node, frames);
  nav2::ForeignController controller(controller_node, frames, argv[1]);
  std::cout << "ready" << std::endl;
  constexpr std::chrono::milliseconds kPause{1};
  auto next = nav2::Clock::now();
  bw::test::poll_until(nav2::Clock::time_point::max(), kPause, [&] {
    frames.poll();
    planner.poll();
    controller.poll();
    if (nav2::Clock::now() >= next) {
      controller.control();
      next = nav2::Clock::now() + kControl;
    }
    return interrupted != 0;
  });
  std::cout << planner.plans() << " plans, " << controller.preemptions() << " preemptions" << std::endl;
  return 0;
}
