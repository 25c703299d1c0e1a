// supervised WORD...: a process that says and does what its words are, one after the other.
//   ready           READY=1
//   live            WATCHDOG=1 each 50 ms until SIGTERM, then STOPPING=1 and status 0
//   silent          nothing until SIGTERM, then status 0
//   deaf            nothing, SIGTERM or not
//   over            STOPPING=1, by its own decision
//   =TEXT           a line on standard error
//   N               ends with this status
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "runtime/host/service_manager.hpp"

int main(int argc, char** argv) {
  const bw::ServiceManager manager;
  sigset_t term;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  sigprocmask(SIG_BLOCK, &term, nullptr);
  const auto lives = [&] {
    for (constexpr timespec kPause{.tv_sec = 0, .tv_nsec = 50'000'000};
         sigtimedwait(&term, nullptr, &kPause) < 0;)
      manager.alive();
    manager.stopping("asked to end", true);
    return 0;
  };
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "ready") {
      manager.ready("up");
    } else if (word == "live") {
      return lives();
    } else if (word == "silent") {
      return sigwaitinfo(&term, nullptr) > 0 ? 0 : 1;
    } else if (word == "deaf") {
      sigset_t none;
      sigemptyset(&none);
      sigaddset(&none, SIGUSR1);
      sigprocmask(SIG_BLOCK, &none, nullptr);
      sigwaitinfo(&none, nullptr);
    } else if (word == "over") {
      manager.stopping("goal reached", true);
    } else if (word.front() == '=') {
      std::cerr << word.substr(1) << std::endl;
    } else {
      return std::atoi(argv[i]);
    }
  }
  return 0;
}
