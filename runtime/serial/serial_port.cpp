#include "runtime/serial/serial_port.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "runtime/serial/open_line.hpp"
#include "runtime/serial/tty_settings.hpp"

namespace bw {
namespace {

constexpr Duration kBetweenAttempts = Duration::milliseconds(500);
constexpr Duration kWhilePatient = Duration::milliseconds(50);
/// More than any device sends between two calls, and no more than a lane copies in a moment.
constexpr std::size_t kReadSize = 65'536;
constexpr const char* kGone = "the line is gone: cable pulled, or the device lost its power";

}  // namespace

struct SerialPort::Attempt {
  OpenedLine line;  ///< the worker's until `is_done`
  std::atomic<bool> is_done = false;
};

SerialPort::SerialPort(PortOptions options, std::string name, Duration patience, SystemFolders folders)
    : options_(std::move(options)),
      name_(std::move(name)),
      patience_(patience),
      folders_(std::move(folders)),
      buffer_(kReadSize) {
  state_.device = name_.empty() ? options_.port : name_;
  state_.fault = "not opened yet";
  state_.is_opening = true;
}

SerialPort::~SerialPort() {
  give_up_descriptor();
  // Jobs go in their order: what an attempt still opens is there when this one comes.
  if (attempt_)
    jobs_.add([attempt = attempt_] {
      if (attempt->line.descriptor >= 0) ::close(attempt->line.descriptor);
    });
}

const LinkState& SerialPort::update(Time now) {
  jobs_.rethrow();
  if (!first_update_) first_update_ = now;
  if (attempt_ && attempt_->is_done) look_at_attempt(now);
  if (descriptor_ >= 0) {
    pollfd line{.fd = descriptor_, .events = POLLIN, .revents = 0};
    if (poll(&line, 1, 0) > 0 && (line.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) lose(kGone);
  }
  const Duration wait = state_.is_opening ? kWhilePatient : kBetweenAttempts;
  const bool is_due = !tried_ || now - *tried_ >= wait || now < *tried_;
  if (descriptor_ < 0 && !attempt_ && is_due) begin_attempt(now);
  return state_;
}

void SerialPort::begin_attempt(Time now) {
  tried_ = now;
  attempt_ = std::make_shared<Attempt>();
  jobs_.add([attempt = attempt_, options = options_, folders = folders_] {
    attempt->line = open_line(options, folders);
    attempt->is_done = true;
  });
}

/// Before it was ever open.
bool SerialPort::is_patient(Time now) const {
  return state_.openings == 0 && now >= *first_update_ && now - *first_update_ < patience_;
}

void SerialPort::look_at_attempt(Time now) {
  const OpenedLine line = attempt_->line;
  attempt_.reset();
  if (name_.empty()) state_.device = line.device;
  state_.fault = line.fault;
  state_.is_opening = !line.fault.empty() && is_patient(now);
  if (!line.fault.empty()) return;
  descriptor_ = line.descriptor;
  state_.is_open = true;
  ++state_.openings;
}

std::span<const std::uint8_t> SerialPort::read() {
  std::size_t count = 0;
  while (descriptor_ >= 0 && count < buffer_.size()) {
    const ssize_t got = ::read(descriptor_, buffer_.data() + count, buffer_.size() - count);
    if (got > 0) {
      count += static_cast<std::size_t>(got);
    } else if (got < 0 && errno == EAGAIN) {
      break;
    } else if (got == 0 || errno != EINTR) {
      lose(kGone);
    }
  }
  return {buffer_.data(), count};
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) {
  if (descriptor_ < 0) return false;
  const ssize_t taken = ::write(descriptor_, bytes.data(), bytes.size());
  if (taken < 0 && errno != EAGAIN && errno != EINTR) lose(kGone);
  return taken == static_cast<ssize_t>(bytes.size());
}

void SerialPort::close(Time now, const std::string& why) {
  tried_ = now;
  lose(why);
}

bool SerialPort::set_dtr(bool is_set) {
  if (descriptor_ < 0) return false;
  jobs_.add([descriptor = descriptor_, is_set] { static_cast<void>(set_dtr_line(descriptor, is_set)); });
  return true;
}

void SerialPort::lose(const std::string& why) {
  state_.is_open = false;
  state_.fault = why;
  give_up_descriptor();
}

void SerialPort::give_up_descriptor() {
  if (descriptor_ < 0) return;
  jobs_.add([descriptor = std::exchange(descriptor_, -1)] { drain_and_close(descriptor); });
}

}  // namespace bw
