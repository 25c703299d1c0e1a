#include "runtime/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bw {
namespace {

std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    if (!changes.contains(std::string(text.substr(0, text.find('='))))) all.emplace_back(text);
  }
  for (const auto& [name, value] : changes) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// In the child: only calls that are allowed between fork and exec.
[[noreturn]] void become(char* const* arguments, char* const* environment, int out, int log, bool is_apart,
                         pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);  // it has gone already
  if (is_apart) setpgid(0, 0);
  dup2(out, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execve(arguments[0], arguments, environment);
  _exit(127);
}

int open_log(const std::filesystem::path& path) {
  std::filesystem::create_directories(path.parent_path());
  const int log = open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) throw std::runtime_error(path.string() + ": " + std::strerror(errno));
  return log;
}

}  // namespace

ChildProcess::ChildProcess(const ChildProcessOptions& options) {
  const int log = options.outputs ? options.outputs->second : open_log(options.log);
  const int out = options.outputs ? options.outputs->first : options.keeps_output ? log : STDERR_FILENO;
  std::vector<std::string> command = options.command;
  std::vector<std::string> environment = environment_with(options.environment);
  const std::vector<char*> arguments = pointers_to(command);
  const std::vector<char*> variables = pointers_to(environment);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ == 0) become(arguments.data(), variables.data(), out, log, options.is_apart, parent);
  if (!options.outputs) close(log);
  if (id_ < 0) throw std::runtime_error(command.front() + ": " + std::strerror(errno));
}

ChildProcess::~ChildProcess() {
  using Clock = std::chrono::steady_clock;
  const auto limit = Clock::now() + std::chrono::seconds(1);
  signal(SIGTERM);
  while (!status() && Clock::now() < limit) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  if (status_) return;
  signal(SIGKILL);
  waitpid(id_, nullptr, 0);
}

std::optional<int> ChildProcess::status() {
  int status = 0;
  if (!status_ && waitpid(id_, &status, WNOHANG) == id_)
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return status_;
}

void ChildProcess::signal(int number) const {
  if (!status_) kill(id_, number);
}

std::string status_in_words(int status) {
  constexpr int kSignalled = 128;
  if (status < 0) return "was not started";
  if (status <= kSignalled) return "ended with status " + std::to_string(status);
  return "was killed by signal " + std::to_string(status - kSignalled) + " (" +
         sigdescr_np(status - kSignalled) + ")";
}

std::string last_words(const std::filesystem::path& log) {
  constexpr std::size_t kMax = 500;
  std::ifstream in(log, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return text.substr(text.size() - std::min(text.size(), kMax));
}

}  // namespace bw
