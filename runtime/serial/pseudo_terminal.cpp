#include "runtime/serial/pseudo_terminal.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "runtime/serial/tty_settings.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPseudoTerminalReadSize = 65'536;

/// Once opened and closed again, a pseudo-terminal tells by POLLHUP that nobody listens. What the host says
/// before it has set the line must not come back as an echo: raw from the start.
std::string make_raw_and_hung_up(const std::string& slave) {
  const int descriptor = open(slave.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return std::strerror(errno);
  std::string fault = set_raw_line(descriptor, 115'200);
  ::close(descriptor);
  return fault;
}

}  // namespace

PseudoTerminal::PseudoTerminal(fs::path link) : link_(std::move(link)), buffer_(kPseudoTerminalReadSize) {
  state_.device = link_.string();
  state_.fault = "not plugged in yet";
}

PseudoTerminal::~PseudoTerminal() { pull(); }

const LinkState& PseudoTerminal::update(Time) {
  if (master_ < 0) plug_in();
  return state_;
}

void PseudoTerminal::plug_in() {
  std::array<char, 64> name{};
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0 ||
      ptsname_r(master_, name.data(), name.size()) != 0) {
    close({}, fmt::format("no pseudo-terminal to be had: {}", std::strerror(errno)));
    return;
  }
  slave_ = name.data();
  if (const std::string fault = make_raw_and_hung_up(slave_); !fault.empty()) {
    close({}, slave_ + ": " + fault);
    return;
  }
  if (!place_link()) return;
  state_.is_open = true;
  state_.fault.clear();
  ++state_.openings;
}

std::string PseudoTerminal::target() const { return fmt::format("/proc/{}/root{}", getpid(), slave_); }

bool PseudoTerminal::place_link() {
  std::error_code error;
  if (const fs::path other = fs::read_symlink(link_, error); !error && fs::exists(link_, error)) {
    close({}, fmt::format("{} belongs to another emulator already: it leads to {}", link_.string(),
                          other.string()));
    return false;
  }
  // Made apart and moved there: whoever looks finds the old one or the new one, whole.
  const fs::path made = fmt::format("{}.{}", link_.string(), getpid());
  fs::remove(made, error);
  fs::create_symlink(target(), made, error);
  if (!error) fs::rename(made, link_, error);
  if (error) close({}, fmt::format("cannot make {}: {}", link_.string(), error.message()));
  return !error;
}

std::span<const std::uint8_t> PseudoTerminal::read() {
  std::size_t count = 0;
  while (master_ >= 0 && count < buffer_.size()) {
    const ssize_t got = ::read(master_, buffer_.data() + count, buffer_.size() - count);
    // EIO: nobody has the other end open, which is no fault of a device.
    if (got <= 0 && !(got < 0 && errno == EINTR)) break;
    if (got > 0) count += static_cast<std::size_t>(got);
  }
  return {buffer_.data(), count};
}

bool PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
  if (master_ < 0) return false;
  pollfd line{.fd = master_, .events = POLLOUT, .revents = 0};
  if (poll(&line, 1, 0) >= 0 && (line.revents & POLLHUP) != 0) return true;
  return ::write(master_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

void PseudoTerminal::close(Time, const std::string& why) {
  // The link first, so that nobody opens what is about to go; another's is left alone.
  std::error_code error;
  if (!slave_.empty() && fs::read_symlink(link_, error) == target()) fs::remove(link_, error);
  slave_.clear();
  if (master_ >= 0) ::close(std::exchange(master_, -1));
  state_.is_open = false;
  state_.fault = why;
}

}  // namespace bw
