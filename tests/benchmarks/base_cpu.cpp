// Measures in real time what share of a core a base's driver and robot_base take: a process of their own, with a real driver at the
// pseudo-terminal of its emulator; floor, emulator and the commander of its wheels are another process.
//   base_cpu ROBOT.yaml [SECONDS]          a robot file such as config/robots/kobuki.yaml
// CPU time of the whole process, DDS included, and of each of its threads; other programs on the machine take no part in it, but
// caches that they wash out do. Asked: less than 2 % of a core. A measurement, not a test: it judges nothing.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "components/messages/wheel_joints.hpp"
#include "components/model/robot.hpp"
#include "runtime/host/host.hpp"

namespace bw {
namespace {

/// motor_control's part: 50 commands a second.
class Commander final : public Component {
 public:
  void configure(Setup& setup) override {
    const WheelRadii radii = setup.shared<Robot>("robot").wheel_radii();
    setup.every(Duration::milliseconds(20), "commands",
                [radii, out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](
                    const Tick& tick) mutable {
                  out.publish(to_joint_state({0.2, 0.25}, radii, tick.now));
                });
  }
};

constexpr const char* kGraph = R"(
components:
  world: {enabled: false, manager: none, process: floor, lane: world,
          emulation: {base: {enabled: true, parameters: {encoder_rate: 100}}},
          parameters: {walls: [{x1: -50, y1: 20, x2: 50, y2: 20}]}}
  base_emulator: {enabled: false, manager: none, process: floor, lane: devices, emulation: {base: {enabled: true}}}
  robot_base: {manager: none, process: base, lane: base, inputs: {wheel_commands: {external: true}}}
)";

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// [s] of each thread, by its name.
std::map<std::string, double> thread_seconds() {
  std::map<std::string, double> all;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    double nanoseconds = 0.0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    all[name] += 1e-9 * nanoseconds;
  }
  return all;
}

void measure(double seconds) {
  using std::chrono::duration;
  std::this_thread::sleep_for(duration<double>(5.0));  // it starts, and finds the others
  const auto began = std::chrono::steady_clock::now();
  const double before = cpu_seconds();
  auto threads = thread_seconds();
  std::this_thread::sleep_for(duration<double>(seconds));
  const double took = cpu_seconds() - before;
  const double share = 100.0 / duration<double>(std::chrono::steady_clock::now() - began).count();
  std::printf("driver and base: %.2f %% of a core\n", share * took);
  for (const auto& [name, now] : thread_seconds()) {
    const double of_thread = share * (now - threads[name]);
    if (of_thread >= 0.01) std::printf("  %-16s %.2f %%\n", name.c_str(), of_thread);
  }
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s ROBOT.yaml [SECONDS]\n", argv[0]);
    return 2;
  }
  const double seconds = argc < 3 ? 60.0 : std::max(1.0, std::atof(argv[2]));
  const auto path =
      std::filesystem::temp_directory_path() / ("base_cpu_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(path) << "robot: " << std::filesystem::absolute(argv[1]).string() << bw::kGraph;
  const auto graph = [&path] { return bw::load_graph(path, {"robot.laser.driver=none", "emulate=true"}); };
  const pid_t floor = fork();
  if (floor == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::vector<bw::ExtraComponent> extra;
    extra.push_back({"commander", std::make_unique<bw::Commander>(), "commander"});
    bw::Host host(graph(), {.only_process = "floor"}, std::move(extra));
    host.run(bw::Duration::seconds(seconds + 60.0));
    return 0;
  }
  {
    bw::Host host(graph(), {.only_process = "base"});
    std::thread meter([&host, seconds] {
      bw::measure(seconds);
      host.finish({}, false);
    });
    host.run(std::nullopt);
    meter.join();
  }
  kill(floor, SIGKILL);
  waitpid(floor, nullptr, 0);
  std::filesystem::remove(path);
  return 0;
}
