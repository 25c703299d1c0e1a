// Virtual time on one thread: events in a total order of (time, rank in the graph, sequence), as fast as the
// machine allows.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <queue>
#include <thread>
#include <vector>

#include "runtime/host/event_source.hpp"
#include "runtime/host/outside.hpp"
#include "runtime/host/runner.hpp"
#include "runtime/host/sample_hash.hpp"

namespace bw {

struct LockstepOptions {
  double pace = 0.0;              ///< virtual seconds per real second; 0 as fast as possible
  Time start;                     ///< where virtual time begins
  EventSource* source = nullptr;  ///< what happens besides the components' own events
  Outside* outside = nullptr;     ///< what other participants send
};

class LockstepRunner final : public Runner {
 public:
  /// Where virtual time begins: positive, and small enough that seconds in a double keep nanoseconds.
  static constexpr Time kStart{1'000'000'000'000};
  /// More events than this at one instant are a loop.
  static constexpr int kMaxEventsPerInstant = 1000;

  LockstepRunner(std::vector<Actor*> actors, const LockstepOptions& options);

  Time now() const override { return now_; }
  void arrived(InputEndpoint& inlet) override;
  void schedule(Timer& timer, Time at) override;
  void publish(OutputEnd& output, std::span<const std::uint8_t> cdr) override;
  void when_done(std::function<void()> action) override;
  /// Throws std::runtime_error naming the callbacks of an endless loop.
  RunEnd run(std::optional<Duration> duration) override;
  void finish(RunEnd end, Duration grace) override;

  /// Of every sample written so far: topic, virtual time, bytes.
  std::string samples_sha256() const { return hash_.hex(); }

 private:
  struct Event {
    Time time;
    std::size_t rank = 0;
    std::uint64_t sequence = 0;
    Actor* actor = nullptr;
    InputEndpoint* inlet = nullptr;  ///< something arrived
    Timer* timer = nullptr;          ///< a tick is due; with neither: the actor's latency has passed
    bool was_deferred = false;       ///< waited for a busy actor
    bool operator>(const Event& other) const {
      return std::tie(time, rank, sequence) > std::tie(other.time, other.rank, other.sequence);
    }
  };
  /// An actor inside its declared latency.
  struct Busy {
    std::vector<std::function<void()>> held;
    std::vector<Event> deferred;
  };

  std::optional<Time> next_time() const;
  void go_to(Time time);
  void push(Event event);
  void dispatch(const Event& event);
  void schedule_next(Timer& timer, Time due);
  void complete(Actor& actor);
  void write(OutputEnd& output, std::span<const std::uint8_t> cdr);
  void count_event(const Event& event);
  void wait_for_pace() const;

  std::vector<Actor*> actors_;
  LockstepOptions options_;
  std::thread::id thread_ = std::this_thread::get_id();  ///< what other threads bring is from outside
  Time now_;
  Duration real_start_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  std::uint64_t next_sequence_ = 0;
  std::map<std::size_t, Busy> busy_;  ///< by rank
  Busy* collecting_ = nullptr;        ///< what the running callback has said is held there
  SampleHash hash_;
  int events_at_now_ = 0;
  std::map<std::string, int> instant_callbacks_;

  std::mutex finish_mutex_;
  std::optional<RunEnd> end_;
  std::atomic<bool> end_requested_ = false;
  Duration grace_;
};

}  // namespace bw
