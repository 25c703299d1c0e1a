#include "tests/interop/cable/cable_between.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

namespace bw::test {
namespace {

void make_raw(int descriptor) {
  termios settings{};
  tcgetattr(descriptor, &settings);
  cfmakeraw(&settings);
  tcsetattr(descriptor, TCSANOW, &settings);
}

constexpr int kLookForDevice = 10;  // [ms] between two looks, while it is not there

}  // namespace

CableBetween::CableBetween(std::filesystem::path device, std::filesystem::path host)
    : device_path_(std::move(device)),
      host_path_(std::move(host)),
      events_(epoll_create1(EPOLL_CLOEXEC)),
      end_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  wait_for(end_, EPOLLIN);
  put_back();
  thread_ = std::thread([this] { pass_on(); });
}

CableBetween::~CableBetween() {
  is_over_ = true;
  eventfd_write(end_, 1);
  thread_.join();
  pull();
  if (device_ >= 0) close(device_);
  close(end_);
  close(events_);
}

/// What is closed is no longer waited for.
void CableBetween::wait_for(int descriptor, std::uint32_t what) {
  epoll_event event{.events = what, .data = {}};
  if (epoll_ctl(events_, EPOLL_CTL_ADD, descriptor, &event) != 0)
    throw std::runtime_error("cannot wait for a descriptor");
}

std::chrono::steady_clock::time_point CableBetween::pull() {
  const std::lock_guard lock(mutex_);
  std::filesystem::remove(host_path_);
  if (master_ >= 0) close(std::exchange(master_, -1));
  return std::chrono::steady_clock::now();
}

void CableBetween::put_back() {
  const std::lock_guard lock(mutex_);
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 64> name{};
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0 ||
      ptsname_r(master_, name.data(), name.size()) != 0)
    throw std::runtime_error("no pseudo-terminal");
  make_raw(master_);
  ++pluggings_;
  // By the edge: a master without a host at its other end is always ready.
  wait_for(master_, EPOLLIN | EPOLLET);
  std::filesystem::create_symlink(name.data(), host_path_);
}

std::vector<Chunk> CableBetween::take_sent() {
  const std::lock_guard lock(mutex_);
  return std::exchange(sent_, {});
}

void CableBetween::open_device() {
  device_ = open(device_path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (device_ < 0) return;
  make_raw(device_);
  wait_for(device_, EPOLLIN);
}

void CableBetween::pass_on() {
  while (!is_over_) {
    if (device_ < 0) open_device();
    {
      const std::lock_guard lock(mutex_);
      pass_from_host(master_);
      pass_from_device(master_);
    }
    epoll_event event{};
    epoll_wait(events_, &event, 1, device_ < 0 ? kLookForDevice : -1);
  }
}

void CableBetween::pass_from_host(int master) {
  std::array<std::uint8_t, 4096> block{};
  for (ssize_t size = 0; master >= 0 && (size = read(master, block.data(), block.size())) > 0;) {
    sent_.push_back({std::chrono::steady_clock::now(), pluggings_, {block.begin(), block.begin() + size}});
    if (device_ >= 0 && write(device_, block.data(), static_cast<std::size_t>(size)) != size)
      sent_.back().bytes.clear();
  }
}

void CableBetween::pass_from_device(int master) {
  std::array<std::uint8_t, 4096> block{};
  ssize_t size = 0;
  while (device_ >= 0 && (size = read(device_, block.data(), block.size())) > 0) {
    // Pulled, or without a host: lost, as on every cable.
    if (master >= 0) static_cast<void>(write(master, block.data(), static_cast<std::size_t>(size)));
  }
  if (device_ >= 0 && (size == 0 || errno != EAGAIN)) close(std::exchange(device_, -1));
}

}  // namespace bw::test
