#include "tests/interop/process.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bw::test {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> with_own_environment(std::map<std::string, std::string> variables) {
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    variables.emplace(text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
  }
  std::vector<std::string> texts;
  texts.reserve(variables.size());
  for (const auto& [name, value] : variables) texts.push_back(std::string(name).append("=").append(value));
  return texts;
}

std::string content(int descriptor) {
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t size = pread(descriptor, block.data(), block.size(), static_cast<off_t>(text.size()));
    if (size <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

Process::Process(const std::vector<std::string>& command,
                 const std::map<std::string, std::string>& environment)
    : out_(memfd_create("out", MFD_CLOEXEC)), err_(memfd_create("err", MFD_CLOEXEC)) {
  const std::vector<std::string> variables = with_own_environment(environment);
  const std::vector<char*> arguments = pointers(command);
  const std::vector<char*> environment_block = pointers(variables);
  id_ = fork();
  if (id_ < 0 || out_ < 0 || err_ < 0) throw std::runtime_error("cannot start " + command.front());
  if (id_ > 0) return;
  // Only async-signal-safe calls from here on: the parent may have threads.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(out_, STDOUT_FILENO);
  dup2(err_, STDERR_FILENO);
  execve(arguments.front(), arguments.data(), environment_block.data());
  _exit(127);
}

Process::~Process() {
  if (running()) {
    signal(SIGKILL);
    wait(std::chrono::seconds(5));
  }
  close(out_);
  close(err_);
}

void Process::signal(int number) const {
  if (!status_) kill(id_, number);
}

bool Process::running() { return !wait(std::chrono::milliseconds(0)); }

std::optional<int> Process::wait(std::chrono::milliseconds limit) {
  for (const auto end = Clock::now() + limit; !status_;) {
    int raw = 0;
    if (waitpid(id_, &raw, WNOHANG) == id_) {
      status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    } else if (Clock::now() >= end) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  return status_;
}

std::string Process::out() const { return content(out_); }
std::string Process::err() const { return content(err_); }

Outcome run_to_end(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                   const std::map<std::string, std::string>& environment) {
  Process process(command, environment);
  const int status = process.wait(limit).value_or(-1);
  return {.status = status, .out = process.out(), .err = process.err()};
}

}  // namespace bw::test
