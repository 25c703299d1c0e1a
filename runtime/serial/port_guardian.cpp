#include "runtime/serial/port_guardian.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/parameters/own_program.hpp"
#include "runtime/serial/guardian_protocol.hpp"

namespace bw {
namespace {

using namespace guardian;

std::int64_t steady_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

std::string beside_this_program() { return (own_program().parent_path() / kProgram).string(); }

std::string hex_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

/// In a session of its own and with every signal blocked from its first instruction: neither Ctrl-C, nor
/// Ctrl-Z, nor a closed terminal, nor a signal to the whole process group reaches it. Returns the error, 0:
/// started.
int start(const std::string& program, const std::vector<std::string>& words, int socket, int port,
          pid_t& process) {
  posix_spawnattr_t how;
  posix_spawnattr_init(&how);
  sigset_t all;
  sigfillset(&all);
  posix_spawnattr_setsigmask(&how, &all);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  // Both are above the numbers that they get: the duplicates of `clear_of_ours`.
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, socket, kSocket);
  posix_spawn_file_actions_adddup2(&files, port, kPort);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error = posix_spawn(&process, program.c_str(), &files, &how, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&how);
  return error;
}

/// A duplicate that is closed by exec and is none of the guardian's numbers.
int clear_of_ours(int descriptor) { return fcntl(descriptor, F_DUPFD_CLOEXEC, kPort + 1); }

/// True when it has ended.
bool ends_within(pid_t process, std::chrono::milliseconds limit) {
  for (std::chrono::milliseconds waited{0}; waited <= limit; waited += std::chrono::milliseconds(1)) {
    if (waitpid(process, nullptr, WNOHANG) != 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace

PortGuardian::PortGuardian(const GuardedDevice& device, std::span<const std::uint8_t> stop_frame) {
  const std::string program = device.program.empty() ? beside_this_program() : device.program;
  std::array<int, 2> pair{-1, -1};
  int error = socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) == 0 ? 0 : errno;
  if (error == 0) {
    const int its_end = clear_of_ours(pair[1]);
    const int its_port = clear_of_ours(device.descriptor);
    error = its_end < 0 || its_port < 0
                ? errno
                : start(program, {kProgram, std::to_string(getpid()), device.name, hex_of(stop_frame)},
                        its_end, its_port, process_);
    for (const int descriptor : {pair[1], its_end, its_port})
      if (descriptor >= 0) close(descriptor);
  }
  socket_ = pair[0];
  if (error == 0) return;
  process_ = -1;
  state_ = State::gone;
  fault_ = fmt::format("its guardian {} cannot be started: {}", program, std::strerror(error));
}

PortGuardian::~PortGuardian() {
  say(kRelease);
  if (process_ >= 0 && !ends_within(process_, std::chrono::milliseconds(300))) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  // Not before: closed with answers unread it would be reset, and the release unheard.
  if (socket_ >= 0) close(socket_);
}

PortGuardian::State PortGuardian::look() {
  char message = 0;
  while (state_ == State::well) {
    const ssize_t got = recv(socket_, &message, 1, MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) break;
    if (got <= 0) state_ = State::gone;
    if (got > 0 && message == kTripped) state_ = State::tripped;
    if (got > 0 && message == kAnswer) unanswered_ = 0;
  }
  if (state_ == State::well && unanswered_ > kMaxUnanswered) state_ = State::gone;
  return state_;
}

void PortGuardian::beat() {
  const std::int64_t now = steady_ns();
  if (now - said_ns_ < std::chrono::nanoseconds(kHeartbeatPeriod).count()) return;
  said_ns_ = now;
  ++unanswered_;
  say(kHeartbeat);
}

void PortGuardian::rest() {
  unanswered_ = 0;
  said_ns_ = 0;
  say(kRest);
}

void PortGuardian::say(char message) const {
  if (socket_ >= 0) send(socket_, &message, 1, MSG_DONTWAIT | MSG_NOSIGNAL);
}

}  // namespace bw
