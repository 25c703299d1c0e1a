// Programs that want a terminal, in tests.
#pragma once

#include <array>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "tests/interop/eventually.hpp"

namespace bw::test {

/// The program on a terminal of its own, ended by its own id.
class OnTerminal {
 public:
  explicit OnTerminal(std::vector<std::string> command) {
    command.insert(command.begin(), BANDWAGON_PROGRAM);
    std::vector<char*> arguments;
    for (std::string& text : command) arguments.push_back(text.data());
    arguments.push_back(nullptr);
    id_ = forkpty(&master_, nullptr, nullptr, nullptr);
    if (id_ < 0) throw std::runtime_error("no terminal");
    if (id_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      execv(arguments.front(), arguments.data());
      _exit(127);
    }
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~OnTerminal() {
    if (!status_) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
    hang_up();
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  void press(const std::string& keys) const {
    ASSERT_EQ(write(master_, keys.data(), keys.size()), std::ssize(keys));
  }
  void end() const { signal(SIGTERM); }
  void signal(int number) const { kill(id_, number); }
  /// As a window that is closed.
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  /// What it has written since the last call of forget().
  const std::string& out() {
    std::array<char, 4096> block{};
    for (ssize_t size = 0; (size = read(master_, block.data(), block.size())) > 0;)
      out_.append(block.data(), static_cast<std::size_t>(size));
    return out_;
  }
  void forget() { out_.clear(); }
  bool shows(const std::string& text) {
    return eventually([&] { return out().find(text) != std::string::npos; });
  }
  /// Enter is needed and keys are echoed, as a terminal is when it is left alone.
  bool is_ordinary() const {
    termios now{};
    tcgetattr(master_, &now);
    return (now.c_lflag & ICANON) != 0 && (now.c_lflag & ECHO) != 0;
  }
  std::optional<int> status() {
    eventually([&] {
      out();  // a full terminal would hold it up
      int raw = 0;
      if (waitpid(id_, &raw, WNOHANG) == id_)
        status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
      return status_.has_value();
    });
    return status_;
  }

 private:
  pid_t id_ = -1;
  int master_ = -1;
  std::string out_;
  std::optional<int> status_;
};

}  // namespace bw::test
