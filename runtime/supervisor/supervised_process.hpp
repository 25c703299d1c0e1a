// What becomes of one process that is looked after: started, awaited, watched, started again, given up. Events in,
// one thing to do out; no process, socket or clock: times are the steady clock's.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "runtime/base/time.hpp"
#include "runtime/supervisor/notification.hpp"

namespace bw {

struct SupervisionLimits {
  Duration ready = Duration::milliseconds(60'000);  ///< READY=1 has to come within
  Duration watchdog = Duration::milliseconds(900);  ///< WATCHDOG=1 after the last one
  Duration stop = Duration::milliseconds(15'000);   ///< its end, once it is asked to end or says STOPPING=1
  int restarts = 5;                                 ///< within `window`; one more is the end
  Duration window = Duration::milliseconds(60'000);
  /// Before the second restart within the window, and twice that before each after it; the first one is at once.
  Duration pause = Duration::milliseconds(200);
};

class SupervisedProcess {
 public:
  explicit SupervisedProcess(const SupervisionLimits& limits = {}) : limits_(limits) {}

  enum class State { waiting, starting, up, stopping, ended };
  enum class Act {
    nothing,
    start,
    terminate,  ///< SIGTERM: it brings what moves to rest first
    kill,       ///< SIGKILL: it does not
  };

  /// What is to be done now. Each is told once.
  [[nodiscard]] Act next(Duration now);
  void started(Duration now);
  void heard(const Notification& said, Duration now);
  /// It ended with `status`, as ChildProcess tells it; `last_words` is what it printed last.
  void ended(int status, const std::string& last_words, Duration now);
  /// From now on it is to end; `again`: and to be started anew, which no limit counts.
  void ask_to_end(bool again);

  [[nodiscard]] State state() const { return state_; }
  /// It has ended and is not started again.
  [[nodiscard]] bool is_done() const { return state_ == State::ended; }
  /// It failed too often, or cannot be configured: why. Empty otherwise.
  [[nodiscard]] const std::string& given_up() const { return given_up_; }
  [[nodiscard]] std::optional<int> last_status() const { return last_status_; }
  /// Of the last end, with its last words; empty: there was none.
  [[nodiscard]] const std::string& last_end() const { return last_end_; }
  [[nodiscard]] int starts() const { return starts_; }
  /// From the start to READY=1; nothing before that.
  [[nodiscard]] std::optional<Duration> time_to_ready() const { return time_to_ready_; }
  [[nodiscard]] const std::string& status() const { return status_; }
  /// Why it is killed, or was.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  [[nodiscard]] Act kill(const std::string& why);
  void plan_restart(Duration now);

  SupervisionLimits limits_;
  State state_ = State::waiting;
  Duration since_;  ///< of the state
  Duration alive_;  ///< last WATCHDOG=1, or READY=1
  Duration start_at_;
  std::optional<Duration> extended_until_;  ///< by its own word: its end
  bool asked_ = false;                      ///< to end
  bool again_ = false;
  bool told_ = false;  ///< SIGTERM is out
  bool killed_ = false;
  bool hangs_ = false;
  bool is_over_ = false;
  int starts_ = 0;
  std::deque<Duration> failures_;  ///< within the window
  std::optional<int> last_status_;
  std::optional<Duration> time_to_ready_;
  std::string status_, fault_, last_end_, given_up_;
};

[[nodiscard]] std::string text_of(SupervisedProcess::State state);

}  // namespace bw
