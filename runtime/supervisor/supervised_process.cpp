#include "runtime/supervisor/supervised_process.hpp"

#include <algorithm>
#include <csignal>

#include <fmt/format.h>

#include "runtime/child_process.hpp"

namespace bw {

namespace {

constexpr const char* kLastWords = "; last words: ";

}  // namespace

using State = SupervisedProcess::State;
using Act = SupervisedProcess::Act;

Act SupervisedProcess::next(Duration now) {
  switch (state_) {
    case State::waiting:
      return now >= start_at_ ? Act::start : Act::nothing;
    case State::ended:
      return Act::nothing;
    case State::starting:
      if (now - since_ > limits_.ready)
        return kill(fmt::format("did not say READY=1 within {:g} s", limits_.ready.to_seconds()));
      break;
    case State::up:
      if (hangs_) return kill(status_.empty() ? "says that it hangs" : status_);
      if (now - alive_ > limits_.watchdog)
        return kill(fmt::format("no sign of life for {:g} s", limits_.watchdog.to_seconds()));
      break;
    case State::stopping:
      if (now - since_ > limits_.stop && now > extended_until_.value_or(since_))
        return kill(fmt::format("did not end within {:g} s", limits_.stop.to_seconds()));
      break;
  }
  if (!asked_ || told_) return Act::nothing;
  told_ = true;
  state_ = State::stopping;
  since_ = now;
  return Act::terminate;
}

Act SupervisedProcess::kill(const std::string& why) {
  if (killed_) return Act::nothing;
  killed_ = true;
  fault_ = why;
  return Act::kill;
}

void SupervisedProcess::started(Duration now) {
  state_ = State::starting;
  since_ = now;
  told_ = killed_ = hangs_ = is_over_ = false;
  time_to_ready_.reset();
  extended_until_.reset();
  status_.clear();
  fault_.clear();
  ++starts_;
}

void SupervisedProcess::heard(const Notification& said, Duration now) {
  if (state_ == State::waiting || state_ == State::ended) return;
  if (said.status) status_ = *said.status;
  if (said.is_ready && state_ == State::starting) {
    state_ = State::up;
    time_to_ready_ = now - since_;
    since_ = alive_ = now;
  }
  if (said.is_alive) alive_ = now;
  if (said.extended) extended_until_ = now + *said.extended;
  hangs_ |= said.hangs;
  is_over_ |= said.is_over;
  if (said.is_stopping && state_ != State::stopping) {
    state_ = State::stopping;
    since_ = now;
  }
}

void SupervisedProcess::ended(int status, const std::string& last_words, Duration now) {
  constexpr int kWrongConfiguration = 2;
  // Asked to end before it had its handlers, and so before it moved anything: it did what it was asked to.
  constexpr int kTerminated = 128 + SIGTERM;
  last_status_ = told_ && status == kTerminated ? 0 : status;
  last_end_ = status_in_words(status);
  if (!fault_.empty()) last_end_ += ": " + fault_;
  // One that was started again begins with how the one before it ended: those words are not its own.
  if (!last_words.empty()) last_end_ += kLastWords + last_words.substr(0, last_words.find(kLastWords));
  const bool was_wanted = asked_ || is_over_;
  state_ = State::ended;
  if (was_wanted) {
    if (!again_) return;
    asked_ = again_ = false;
    state_ = State::waiting;
    start_at_ = now;
  } else if (status == kWrongConfiguration && !time_to_ready_ && starts_ == 1) {
    given_up_ = last_end_;
  } else {
    plan_restart(now);
  }
}

void SupervisedProcess::plan_restart(Duration now) {
  std::erase_if(failures_, [&](Duration then) { return now - then > limits_.window; });
  const auto before = static_cast<int>(failures_.size());
  if (before >= limits_.restarts) {
    given_up_ = fmt::format("started again {} times within {:g} s, and {}", before,
                            limits_.window.to_seconds(), last_end_);
    return;
  }
  failures_.push_back(now);
  state_ = State::waiting;
  start_at_ = before == 0 ? now : now + limits_.pause * (std::int64_t{1} << (before - 1));
}

void SupervisedProcess::ask_to_end(bool again) {
  if (state_ == State::waiting) {
    if (!again) state_ = State::ended;
    return;
  }
  asked_ = true;
  again_ = again;
}

std::string text_of(State state) {
  switch (state) {
    case State::waiting:
      return "waiting";
    case State::starting:
      return "starting";
    case State::up:
      return "up";
    case State::stopping:
      return "stopping";
    case State::ended:
      return "ended";
  }
  return {};
}

}  // namespace bw
