// The executor against the figures of rclcpp's single-threaded one on this class of machine (29 us median
// with 1 subscription; 341 us and 456 us CPU per message with 200): publish-to-callback latency in one
// process, CPU per message, idle CPU, latency between two processes.
// The first rows are the floor of this machine: compare ratios, not microseconds of different machines.
//   benchmark_executor [--json FILE]
#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>
#include <std_msgs/msg/string.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/base/quantile.hpp"
#include "runtime/host/host.hpp"

namespace bw {
namespace {

using String = std_msgs::msg::String;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto s = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return s(usage.ru_utime) + s(usage.ru_stime);
}

struct Samples {
  std::vector<double> latency_us;
  double quantile(double q) const { return bw::quantile(latency_us, q); }
};

/// A message of 256 bytes that carries the steady time of its sending.
String stamped(std::int64_t now_ns) {
  String message;
  std::string text(256, '.');
  std::snprintf(text.data(), 32, "%lld ", static_cast<long long>(now_ns));
  message.data(text);
  return message;
}

double age_us(const String& message) {
  return 1e-3 * static_cast<double>(steady_time().nanoseconds - std::stoll(message.data()));
}

class Publisher final : public Component {
 public:
  /// `burst` messages every `period`, one topic after the other, `count` in all.
  Publisher(int topics, Duration period, std::uint64_t count, std::uint64_t burst = 1)
      : topics_(topics), period_(period), count_(count), burst_(burst) {}
  void configure(Setup& setup) override {
    for (int i = 0; i < topics_; ++i) out_.push_back(setup.output<String>("t" + std::to_string(i)));
    if (count_ == 0) return;
    setup.every(period_, "publish", [this, finish = setup.finish_run()](const Tick& tick) {
      if (tick.sequence * burst_ >= count_) return finish(true, "done");
      for (std::uint64_t i = 0; i < burst_; ++i) {
        out_[(tick.sequence * burst_ + i) % out_.size()].publish(stamped(steady_time().nanoseconds));
      }
    });
  }

 private:
  int topics_;
  Duration period_;
  std::uint64_t count_;
  std::uint64_t burst_;
  std::vector<Output<String>> out_;
};

class Subscriber final : public Component {
 public:
  Subscriber(int topics, Samples& samples) : topics_(topics), samples_(samples) {}
  void configure(Setup& setup) override {
    for (int i = 0; i < topics_; ++i) {
      setup.input<String>(
          "t" + std::to_string(i), Qos::standard(),
          [this](const String& m, const Tick&) { samples_.latency_us.push_back(age_us(m)); }, Need::optional);
    }
  }

 private:
  int topics_;
  Samples& samples_;
};

struct Figures {
  double median_us = 0.0;
  double p99_us = 0.0;
  double cpu_us_per_message = 0.0;
  std::uint64_t messages = 0;
};

/// Publisher and subscriber on lanes of their own. `period`: short for CPU per message, longer for latency at
/// rest.
Figures one_process(int topics, Duration period, std::uint64_t count, std::uint64_t burst = 1) {
  Samples samples;
  Graph graph;
  std::vector<ExtraComponent> extra;
  extra.push_back({"publisher", std::make_unique<Publisher>(topics, period, count, burst), "publisher"});
  extra.push_back({"subscriber", std::make_unique<Subscriber>(topics, samples), "subscriber"});
  Host host(graph, {.clock = ClockMode::wall}, std::move(extra));
  const double before = cpu_seconds();
  host.run(std::nullopt);
  const double used = cpu_seconds() - before;
  const auto received = samples.latency_us.size();
  return {samples.quantile(0.5), samples.quantile(0.99),
          1e6 * used / static_cast<double>(std::max<std::size_t>(received, 1)), received};
}

/// The floor: a DDS writer, a listener and a thread on a condition variable, nothing else. Woken after the
/// write, as the executor does.
Figures bare_dds(Duration period, std::uint64_t count) {
  dds::Participant participant({.network = dds::Network::from_environment(dds::Transport::localhost)});
  const dds::EndpointOptions options{.topic = "rt/floor",
                                     .type = std::string(MessageTraits<String>::dds_name),
                                     .qos = Qos::standard(),
                                     .user_data = {}};
  const auto reader = participant.create_reader(options, [] {});
  const auto writer = participant.create_writer(options);
  std::mutex mutex;
  std::condition_variable wake;
  std::uint64_t waiting = 0;
  bool done = false;
  Samples samples;
  const double before = cpu_seconds();
  std::thread lane([&] {
    dds::Sample sample;
    String message;
    std::unique_lock lock(mutex);
    while (true) {
      wake.wait(lock, [&] { return waiting > 0 || done; });
      if (waiting == 0) return;
      --waiting;
      lock.unlock();
      if (reader->take(sample) && deserialize(sample.cdr, message))
        samples.latency_us.push_back(age_us(message));
      lock.lock();
    }
  });
  std::vector<std::uint8_t> cdr;
  Duration next = steady_time();
  for (std::uint64_t i = 0; i < count; ++i) {
    next = next + period;
    std::this_thread::sleep_for(std::chrono::nanoseconds((next - steady_time()).nanoseconds));
    serialize(stamped(steady_time().nanoseconds), cdr);
    writer->write(cdr);
    {
      const std::lock_guard lock(mutex);
      ++waiting;
    }
    wake.notify_one();
  }
  {
    const std::lock_guard lock(mutex);
    done = true;
  }
  wake.notify_one();
  lane.join();
  const double used = cpu_seconds() - before;
  const auto received = samples.latency_us.size();
  return {samples.quantile(0.5), samples.quantile(0.99),
          1e6 * used / static_cast<double>(std::max<std::size_t>(received, 1)), received};
}

double idle_percent(int topics, double seconds) {
  Samples samples;
  Graph graph;
  std::vector<ExtraComponent> extra;
  extra.push_back({"publisher", std::make_unique<Publisher>(topics, Duration{}, 0), "publisher"});
  extra.push_back({"subscriber", std::make_unique<Subscriber>(topics, samples), "subscriber"});
  Host host(graph, {.clock = ClockMode::wall}, std::move(extra));
  std::thread ender([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));  // set-up is not idleness
    const double before = cpu_seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(static_cast<int>(seconds * 1e3)));
    samples.latency_us.assign(1, cpu_seconds() - before);
    host.finish({.ok = true, .reason = "measured"}, true);
  });
  host.run(std::nullopt);
  ender.join();
  return 100.0 * samples.latency_us.at(0) / seconds;
}

Figures two_processes(std::uint64_t count) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<ExtraComponent> extra;
    extra.push_back(
        {"publisher", std::make_unique<Publisher>(1, Duration::milliseconds(1), count + 5000), "main"});
    Host host(Graph{}, {.clock = ClockMode::wall}, std::move(extra));
    host.run(std::nullopt);
    _exit(0);
  }
  Samples samples;
  std::vector<ExtraComponent> extra;
  extra.push_back({"subscriber", std::make_unique<Subscriber>(1, samples), "main"});
  Host host(Graph{}, {.clock = ClockMode::wall}, std::move(extra));
  host.run(Duration::seconds(static_cast<double>(count) * 1e-3 + 3.0));
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  return {samples.quantile(0.5), samples.quantile(0.99), 0.0, samples.latency_us.size()};
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  nlohmann::ordered_json json;
  const auto report = [&](const std::string& name, const bw::Figures& f) {
    std::printf("%-42s median %6.1f us  p99 %7.1f us  CPU per message %5.1f us  (%llu messages)\n",
                name.c_str(), f.median_us, f.p99_us, f.cpu_us_per_message,
                static_cast<unsigned long long>(f.messages));
    json[name] = {{"median_us", f.median_us},
                  {"p99_us", f.p99_us},
                  {"cpu_us_per_message", f.cpu_us_per_message},
                  {"messages", f.messages}};
  };
  // Forks while this process has no threads yet.
  report("two processes, localhost", bw::two_processes(4000));
  report("floor (bare DDS and a thread), 1 kHz", bw::bare_dds(bw::Duration::milliseconds(1), 5000));
  report("floor (bare DDS and a thread), 20 kHz", bw::bare_dds(bw::Duration{50'000}, 60000));
  for (const int topics : {1, 200}) {
    const std::string suffix = std::to_string(topics) + " subscriptions";
    report("one process, 1 kHz, " + suffix, bw::one_process(topics, bw::Duration::milliseconds(1), 5000));
    report("one process, 20 kHz, " + suffix, bw::one_process(topics, bw::Duration{50'000}, 60000));
  }
  report("one process, all 200 topics at 100 Hz",
         bw::one_process(200, bw::Duration::milliseconds(10), 60000, 200));
  const double idle = bw::idle_percent(200, 10.0);
  std::printf("idle CPU with 200 subscriptions: %.2f %%\n", idle);
  json["idle_percent_200"] = idle;
  if (argc == 3 && std::string(argv[1]) == "--json") std::ofstream(argv[2]) << json.dump(2) << "\n";
  return 0;
}
