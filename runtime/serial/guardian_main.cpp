// The guardian of a base's port: a process of its own that does nothing but tell the base to stand when the
// process that drives it is gone (SIGKILL, abort, out of memory) or silent (hung, SIGSTOP). It has a second
// descriptor of the open port, so that the port outlives that process for a moment, and knows no protocol:
// the stop frame is given. PortGuardian starts it; by hand it is of no use:
//   bandwagon_port_guardian PID PORT STOP_FRAME_IN_HEX      (descriptors 3 and 4: guardian_protocol.hpp)
// All signals that can be are blocked by who starts it: Ctrl-C is for the base's process, which brings its
// robot to rest by itself.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "runtime/serial/guardian_protocol.hpp"
#include "runtime/serial/tty_settings.hpp"

namespace bw::guardian {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at + 1 < hex.size(); at += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::strtoul(hex.substr(at, 2).c_str(), nullptr, 16)));
  return bytes;
}

class Guardian {
 public:
  Guardian(std::string process, std::string port, std::vector<std::uint8_t> stop_frame)
      : process_(std::move(process)), port_(std::move(port)), stop_frame_(std::move(stop_frame)) {}

  /// Until the process has given the port up, or is gone.
  void guard() {
    heard_ = Clock::now();
    while (phase_ != Phase::over) {
      pollfd ear{.fd = kSocket, .events = POLLIN, .revents = 0};
      const int ready = poll(&ear, 1, patience());
      if (ready > 0) hear();
      if (ready < 0 && errno != EINTR) phase_ = Phase::over;
      if (phase_ == Phase::watching && Clock::now() - heard_ >= kSilence) trip();
      if (phase_ == Phase::tripped && Clock::now() - stopped_ >= kRepeat) stop();
    }
  }

 private:
  enum class Phase { watching, resting, tripped, over };

  /// [ms] that may pass without a message.
  int patience() const {
    using std::chrono::ceil, std::chrono::milliseconds;
    const auto until = [](Clock::time_point end) {
      return static_cast<int>(std::max<std::int64_t>(0, ceil<milliseconds>(end - Clock::now()).count()));
    };
    if (phase_ == Phase::resting) return -1;
    return phase_ == Phase::tripped ? until(stopped_ + kRepeat) : until(heard_ + kSilence);
  }

  void hear() {
    char message = 0;
    const ssize_t got = recv(kSocket, &message, 1, MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (got <= 0) return outlive();
    if (message == kRelease) return release();
    if (phase_ == Phase::tripped)
      return;  // a hang that ends must not drive on: only a port that is opened anew does
    if (message == kHeartbeat) {
      phase_ = Phase::watching;
      heard_ = Clock::now();
      say(kAnswer);
    }
    if (message == kRest) phase_ = Phase::resting;
  }

  void trip() {
    stop();
    phase_ = Phase::tripped;
    say(kTripped);
    tell("is silent");
  }

  void outlive() {
    stop();
    tell("is gone");
    for (int i = 0; i < kLastWords; ++i) {
      poll(nullptr, 0, static_cast<int>(kRepeat.count()));
      stop();
    }
    phase_ = Phase::over;
  }

  void release() {
    stop();
    phase_ = Phase::over;
  }

  /// The port does not block. Bytes that do not fit now go out with the next repetition.
  void stop() {
    stopped_ = Clock::now();
    [[maybe_unused]] const ssize_t taken = write(kPort, stop_frame_.data(), stop_frame_.size());
  }

  static void say(char message) { send(kSocket, &message, 1, MSG_DONTWAIT | MSG_NOSIGNAL); }

  /// After the deed, and only where it does not block.
  void tell(const char* what) const {
    const std::string line =
        "the guardian of " + port_ + ": process " + process_ + " " + what + ", the base is told to stop\n";
    pollfd terminal{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (poll(&terminal, 1, 0) > 0) [[maybe_unused]]
      const ssize_t taken = write(STDERR_FILENO, line.data(), line.size());
  }

  std::string process_, port_;
  std::vector<std::uint8_t> stop_frame_;
  Phase phase_ = Phase::watching;
  Clock::time_point heard_, stopped_;
};

/// Where this user may: it waits for nobody when it is needed.
void come_first() {
  const sched_param priority{.sched_priority = 21};  // one above the base's own lane
  sched_setscheduler(0, SCHED_FIFO, &priority);
  mlockall(MCL_CURRENT | MCL_FUTURE);
}

}  // namespace
}  // namespace bw::guardian

int main(int argc, char** argv) {
  using namespace bw::guardian;
  if (argc != 4) {
    std::fputs("bandwagon_port_guardian is started by the process that drives a base, not by hand\n", stderr);
    return 2;
  }
  // What else the process had open is nothing to hold on to.
  close_range(kPort + 1, ~0U, 0);
  come_first();
  Guardian(argv[1], argv[2], bytes_of(argv[3])).guard();
  close(kSocket);
  bw::drain_and_close(kPort);
  return 0;
}
