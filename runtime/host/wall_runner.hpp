// Real time: one thread per lane. DDS threads only push; everything else happens on lanes.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "runtime/host/commanded_motion.hpp"
#include "runtime/host/component_clock.hpp"
#include "runtime/host/lane_watch.hpp"
#include "runtime/host/runner.hpp"

namespace bw {

class WallRunner final : public Runner {
 public:
  /// Says of an actor on a real-time lane what the system did not allow; called on that lane.
  using Warn = std::function<void(const Actor& actor, const std::string& text)>;
  WallRunner(std::vector<Actor*> actors, ComponentClock& clock, const ServiceManager& manager,
             Warn warn = {});
  ~WallRunner() override;

  Time now() const override { return clock_.now(); }
  void arrived(InputEndpoint& inlet) override;
  void schedule(Timer& timer, Time at) override { timer.next = at; }
  void publish(OutputEnd& output, std::span<const std::uint8_t> cdr) override;
  void when_done(std::function<void()> action) override { run_and_wake(action); }
  RunEnd run(std::optional<Duration> duration) override;
  void finish(RunEnd end, Duration grace) override;

 private:
  /// A worker thread with its queue; the actors on it never run at the same time.
  struct Lane {
    std::string name;
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<InputEndpoint*> queue;
    std::vector<Timer*> timers;
    bool stop = false;
    Duration longest_callback;
    LaneWatch::Lane* watched = nullptr;
    const Actor* real_time = nullptr;  ///< who wants it; null: nobody
    std::thread thread;
  };

  /// Until nothing is told to move any more, for at most `longest`.
  void come_to_rest(Duration longest);
  void start_lanes();
  void run_and_wake(const std::function<void()>& write);
  void enqueue(InputEndpoint& inlet);
  void work(Lane& lane);
  void become_real_time(const Actor& actor) const;
  void fire_if_due(Lane& lane, Timer& timer, std::unique_lock<std::mutex>& lock);
  void fire(Timer& timer, Time now, Duration late, std::unique_lock<std::mutex>& lock);
  void drain(InputEndpoint& inlet);
  void wait(Lane& lane, std::unique_lock<std::mutex>& lock);

  std::vector<Actor*> actors_;
  ComponentClock& clock_;
  LaneWatch watch_;
  Warn warn_;
  std::map<std::string, std::unique_ptr<Lane>> lanes_;
  std::map<const Actor*, Lane*> lane_of_;
  CommandedMotion motion_;
  Lane* acknowledgments_ = nullptr;  ///< of what is taken off the actors' lanes; null where nobody has such

  std::mutex end_mutex_;
  std::condition_variable end_wake_;
  std::optional<RunEnd> end_;
  Duration grace_;
};

}  // namespace bw
