// Real time: one thread per lane. DDS threads only push; everything else happens on lanes.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "runtime/host/component_clock.hpp"
#include "runtime/host/runner.hpp"

namespace bw {

class WallRunner final : public Runner {
 public:
  WallRunner(std::vector<Actor*> actors, ComponentClock& clock);
  ~WallRunner() override;

  Time now() const override { return clock_.now(); }
  void sample_arrived(Input& input) override;
  void publish(OutputEnd& output, std::span<const std::uint8_t> cdr) override;
  RunEnd run(std::optional<Duration> duration) override;
  void finish(RunEnd end, Duration grace) override;

 private:
  /// A worker thread with its queue; the actors on it never run at the same time.
  struct Lane {
    std::string name;
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Input*> queue;
    std::vector<Timer*> timers;
    bool stop = false;
    std::thread thread;
  };

  void enqueue(Input& input);
  void work(Lane& lane);
  void fire_if_due(Lane& lane, Timer& timer, std::unique_lock<std::mutex>& lock);
  void drain(Input& input);
  void wait(Lane& lane, std::unique_lock<std::mutex>& lock);

  std::vector<Actor*> actors_;
  ComponentClock& clock_;
  std::map<std::string, std::unique_ptr<Lane>> lanes_;
  std::map<const Actor*, Lane*> lane_of_;

  std::mutex end_mutex_;
  std::condition_variable end_wake_;
  std::optional<RunEnd> end_;
  Duration grace_;
};

}  // namespace bw
