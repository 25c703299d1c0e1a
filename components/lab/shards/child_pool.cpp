#include "components/lab/shards/child_pool.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <thread>

#include "runtime/child_process.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLook = std::chrono::milliseconds(100);
constexpr auto kTell = std::chrono::seconds(30);  // of what runs
constexpr auto kPatience =
    std::chrono::seconds(20);  // of a child that was asked to end: it finishes what it writes

enum class State { waiting, running, ended };

struct Child {
  State state = State::waiting;
  std::unique_ptr<ChildProcess> process;
  int status = -1;
};

/// True when it has ended now.
bool look_after(Child& child) {
  if (child.state != State::running) return false;
  const std::optional<int> status = child.process->status();
  if (!status) return false;
  child.state = State::ended;
  child.status = *status;
  return true;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Pool {
 public:
  Pool(const std::vector<ChildJob>& jobs, int at_once)
      : jobs_(jobs), at_once_(at_once), children_(jobs.size()) {}
  ~Pool() { signal(SIGKILL), wait_for_all(Clock::now() + kPatience); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void start_what_can() {
    for (std::size_t i = 0; i < jobs_.size() && running() < at_once_; ++i) {
      if (children_[i].state != State::waiting) continue;
      const bool is_ready = std::ranges::all_of(
          jobs_[i].after, [&](std::size_t j) { return children_[j].state == State::ended; });
      if (!is_ready) continue;
      children_[i].process = std::make_unique<ChildProcess>(
          ChildProcessOptions{.command = jobs_[i].command, .log = jobs_[i].log});
      children_[i].state = State::running;
    }
  }

  /// Indices of those that ended since the last call.
  std::vector<std::size_t> ended_now() {
    std::vector<std::size_t> ended;
    for (std::size_t i = 0; i < children_.size(); ++i)
      if (look_after(children_[i])) ended.push_back(i);
    return ended;
  }

  void signal(int number) const {
    for (const Child& child : children_)
      if (child.state == State::running) child.process->signal(number);
  }
  void wait_for_all(Clock::time_point limit) {
    while (running() > 0 && Clock::now() < limit) {
      ended_now();
      std::this_thread::sleep_for(kLook / 10);
    }
  }

  int running() const { return count(State::running); }
  bool is_done() const { return count(State::ended) == std::ssize(children_); }

  ChildProgress progress(Clock::time_point started) const {
    ChildProgress p{.elapsed = std::chrono::duration<double>(Clock::now() - started).count(),
                    .ended = static_cast<std::size_t>(count(State::ended))};
    double done = 0.0, all = 0.0;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      all += jobs_[i].cost;
      if (children_[i].state == State::ended) done += jobs_[i].cost;
      if (children_[i].state == State::running) done += jobs_[i].cost * told_share(text_of(jobs_[i].log));
    }
    p.share = all > 0.0 ? done / all : 1.0;
    if (p.share > 0.0) p.remaining = p.elapsed * (1.0 - p.share) / p.share;
    return p;
  }

  std::vector<int> statuses() const {
    std::vector<int> all;
    for (const Child& child : children_) all.push_back(child.status);
    return all;
  }

 private:
  int count(State state) const {
    return static_cast<int>(std::ranges::count(children_, state, &Child::state));
  }

  const std::vector<ChildJob>& jobs_;
  int at_once_;
  std::vector<Child> children_;
};

}  // namespace

double told_share(const std::string& text) {
  for (std::size_t at = text.rfind('['); at != std::string::npos;
       at = at == 0 ? at : text.rfind('[', at - 1)) {
    double done = 0.0, all = 0.0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data() + at + 1, end, done);
    if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
      const auto second = std::from_chars(first.ptr + 1, end, all);
      if (second.ec == std::errc() && second.ptr != end && *second.ptr == ']' && all > 0.0) return done / all;
    }
    if (at == 0) break;
  }
  return 0.0;
}

std::vector<int> run_children(const std::vector<ChildJob>& jobs, int at_once,
                              const std::function<bool()>& is_interrupted,
                              const std::function<void(const ChildProgress&)>& progress) {
  Pool pool(jobs, at_once);
  const Clock::time_point started = Clock::now();
  Clock::time_point told = started;
  while (!pool.is_done()) {
    if (is_interrupted()) {
      pool.signal(SIGINT);
      pool.wait_for_all(Clock::now() + kPatience);
      break;
    }
    pool.start_what_can();
    for (const std::size_t i : pool.ended_now()) {
      ChildProgress now = pool.progress(started);
      now.job = &jobs[i];
      now.status = pool.statuses()[i];
      progress(now);
      told = Clock::now();
    }
    if (Clock::now() - told >= kTell) {
      progress(pool.progress(started));
      told = Clock::now();
    }
    std::this_thread::sleep_for(kLook);
  }
  return pool.statuses();
}

}  // namespace bw
