// nav2_manager NODE...: plays lifecycle_manager_navigation until it is interrupted, then shuts the nodes
// down. Prints "active", or what went wrong, and "lost NODE" when a bond is lost and all have been taken
// down. Exit status 1 then.
#include <csignal>
#include <iostream>

#include "tests/interop/nav2_tree/manager.hpp"

namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  plain::Node node("lifecycle_manager_navigation");
  nav2::Manager manager(node, {argv + 1, argv + argc});
  if (const auto trouble = manager.startup()) {
    std::cout << *trouble << std::endl;
    return 1;
  }
  std::cout << "active" << std::endl;
  while (interrupted == 0) {
    if (const auto lost = manager.watch(std::chrono::milliseconds(200))) {
      manager.reset();
      std::cout << "lost " << *lost << std::endl;
      return 1;
    }
  }
  manager.shutdown();
  return 0;
}
