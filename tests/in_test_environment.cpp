// in_test_environment COMMAND ARGUMENTS...: runs a test that is no GoogleTest program, or any other command,
// in an environment of its own (test_environment.hpp). Ends as the command does; 128 and the signal's number
// where a signal ended it.
#include <csignal>
#include <cstdio>
#include <exception>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/test_environment.hpp"

namespace {

volatile sig_atomic_t command = 0;  // its process id, once it runs

void pass_on(int number) {
  if (command > 0) kill(command, number);
}

int run(char** arguments) {
  const pid_t own = getpid();
  const pid_t child = fork();
  if (child == 0) {
    // Who is killed leaves nobody behind on the domain.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != own) _exit(1);
    execvp(arguments[0], arguments);
    std::perror(arguments[0]);
    _exit(127);
  }
  if (child < 0) {
    std::perror("fork");
    return 1;
  }
  command = child;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, pass_on);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "usage: in_test_environment COMMAND ARGUMENTS...\n");
    return 2;
  }
  try {
    const bw::test::TestEnvironment environment;
    return run(arguments + 1);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "in_test_environment: %s\n", e.what());
    return 1;
  }
}
