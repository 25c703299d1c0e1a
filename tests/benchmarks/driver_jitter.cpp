// Measures the loop between robot_base and its driver in real time: by how much the time between two polls
// differs from 10 ms, and what share of a core the whole process takes: a driver that counts 100 times a
// second, the base, and the commander of its wheels (a real driver and the base alone: base_cpu). Beside
// `spinners` processes that take all CPU they get.
//   driver_jitter [--normal] [--port|--guarded] [SECONDS [SPINNERS]]
// --normal: without a real-time priority. --port: each poll writes 13 bytes to a pseudo-terminal, as a
// Kobuki's does; --guarded: the same, with a guardian.
// Asked: 2 ms in 999 of 1000 alone, 10 ms beside four spinners where real-time rights are given. A
// measurement, not a test: it judges nothing.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "components/robot_base/driver_registry.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/real_time.hpp"
#include "runtime/serial/guarded_port.hpp"
#include "runtime/serial/pseudo_terminal.hpp"
#include "runtime/temporary_folder.hpp"
#include "tests/benchmarks/commanded_base.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<Clock::time_point>& polls() {
  static std::vector<Clock::time_point> all;
  return all;
}

/// Who reads it, and the port; the guardian's stop frame is as good as any for nobody.
struct Cable {
  explicit Cable(bool is_guarded) : device(folder.path() / "cable") {
    device.update({});
    auto serial = std::make_unique<SerialPort>(PortOptions{.port = (folder.path() / "cable").string()});
    if (is_guarded)
      port = std::make_unique<GuardedPort>(std::move(serial), kBytes);
    else
      port = std::move(serial);
  }
  void exchange(Time now) {
    device.update(now);
    static_cast<void>(device.read());
    if (port->update(now).is_open) written += port->write(kBytes) ? 1U : 0U;
  }

  inline static const std::vector<std::uint8_t> kBytes = std::vector<std::uint8_t>(13, 0xaa);
  TemporaryFolder folder;
  PseudoTerminal device;
  std::unique_ptr<ByteLink> port;
  std::size_t written = 0;
};
std::unique_ptr<Cable>& cable() {
  static std::unique_ptr<Cable> one;
  return one;
}

struct TimedDriverOptions {
  template <class Visitor>
  void fields(Visitor&) {}
};

/// Wheels that rotate as they are told, and a clock.
class TimedDriver final : public Driver {
 public:
  TimedDriver(const TimedDriverOptions&, const DriverContext&) {}
  Readings poll(Time now) override {
    polls().push_back(Clock::now());
    if (cable()) cable()->exchange(now);
    ticks_ += wheels_.left * 0.01 * 5385.0;  // ticks a metre of the generic robot
    Readings readings;
    const auto ticks = static_cast<std::int32_t>(ticks_);
    readings.counts.push_back({now, ticks, ticks});
    readings.contacts = ContactReading{};
    return readings;
  }
  bool command(Time, const WheelSpeeds& wheels) override {
    wheels_ = wheels;
    return true;
  }

 private:
  WheelSpeeds wheels_;
  double ticks_ = 0.0;
};

BW_DRIVER(TimedDriver, TimedDriverOptions, "timed")

pid_t spin() {
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (std::atomic<unsigned> i = 0;;) ++i;
}

void report(double cpu, double seconds) {
  std::vector<double> late;
  const auto& all = polls();
  for (std::size_t i = 101; i < all.size(); ++i)  // the first second is the start of everything
    late.push_back(std::abs(std::chrono::duration<double, std::milli>(all[i] - all[i - 1]).count() - 10.0));
  if (late.empty()) return;
  std::ranges::sort(late);
  const auto quantile = [&](double q) {
    return late[static_cast<std::size_t>(q * static_cast<double>(late.size() - 1))];
  };
  std::printf(
      "%zu polls: off 10 ms by %.3f ms in the median, %.3f ms p99, %.3f ms p99.9, %.3f ms at most; CPU %.2f %% of a core\n",
      late.size(), quantile(0.5), quantile(0.99), quantile(0.999), late.back(), 100.0 * cpu / seconds);
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  bool is_normal = false;
  std::vector<double> numbers;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--normal") == 0)
      is_normal = true;
    else if (std::strcmp(argv[i], "--port") == 0 || std::strcmp(argv[i], "--guarded") == 0)
      bw::cable() = std::make_unique<bw::Cable>(std::strcmp(argv[i], "--guarded") == 0);
    else
      numbers.push_back(std::atof(argv[i]));
  }
  const double seconds = numbers.empty() ? 60.0 : std::max(2.0, numbers[0]);
  const int spinners = numbers.size() < 2 ? 0 : static_cast<int>(numbers[1]);
  const auto path =
      std::filesystem::temp_directory_path() / ("driver_jitter_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(path) << "robot: {base: {driver: timed}}\ncomponents: {robot_base: {lane: base, priority: "
                      << (is_normal ? "normal" : "real_time") << "}}\n";
  const std::string missing = bw::missing_real_time_rights();
  if (!is_normal && !missing.empty()) std::printf("%s\n", missing.c_str());
  std::vector<pid_t> children;
  for (int i = 0; i < spinners; ++i) children.push_back(bw::spin());
  std::vector<bw::ExtraComponent> extra;
  extra.push_back({"commander", std::make_unique<bw::Commander>(bw::WheelSpeeds{0.3, 0.3}), "commander"});
  {
    bw::Host host(bw::load_graph(path), {}, std::move(extra));
    const double before = bw::cpu_seconds();
    host.run(bw::Duration::seconds(seconds));
    bw::report(bw::cpu_seconds() - before, seconds);
    if (bw::cable()) std::printf("%zu writes\n", bw::cable()->written);
  }
  for (const pid_t child : children) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  std::filesystem::remove(path);
  return 0;
}
