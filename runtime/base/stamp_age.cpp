#include "runtime/base/stamp_age.hpp"

#include <algorithm>

namespace bw {
namespace {

Duration drift_over(Duration elapsed) {
  return {static_cast<std::int64_t>(ForeignClock::kDriftMax * static_cast<double>(elapsed.nanoseconds))};
}

}  // namespace

const char* to_text(StampFault fault) {
  switch (fault) {
    case StampFault::none:
      return "none";
    case StampFault::late:
      return "late";
    case StampFault::future:
      return "in the future";
    case StampFault::overtaken:
      return "older than one before";
    case StampFault::unproven:
      return "of a clock that is not known yet";
  }
  return "";
}

void ForeignClock::begin(Time now, Time stamp, Duration known_age) {
  is_begun_ = true;
  is_proven_ = false;
  const Duration lag = now - stamp;
  least_ = lag - known_age;
  proof_ = {lag, lag, now, 1};
  late_.reset();
  if (known_age > kNear) late_ = known_age;
  jump_.reset();
  heard_ = near_ = now;
  newest_stamp_ = stamp;
  seen_stamps_.fill(stamp);
}

/// A stamp that came before says nothing of a clock.
bool ForeignClock::is_repeated(Time stamp) {
  if (std::ranges::find(seen_stamps_, stamp) != seen_stamps_.end()) return true;
  seen_stamps_[next_seen_++ % seen_stamps_.size()] = stamp;
  return false;
}

/// True when the run was constant for long enough. One that comes sooner begins it anew.
bool ForeignClock::proves(Run& run, Time now, Duration lag) {
  if (run.samples == 0 || lag < run.first - kSooner) run = {lag, lag, now, 0};
  run.least = std::min(run.least, lag);
  if (lag <= run.least + kNear) ++run.samples;
  return run.samples >= kEnough && now - run.since >= kProof;
}

/// Samples that are all late are no clock that is slow.
void ForeignClock::follow_drift(Time now) {
  if (heard_ - near_ <= kProof) least_ = least_ + drift_over(now - heard_);
}

StampAge ForeignClock::add(Time now, Time stamp) {
  if (!is_begun_ || now < heard_) {
    const bool was_proven = is_proven_;
    begin(now, stamp, {});
    return {{}, StampFault::unproven, was_proven};
  }
  const Duration elapsed = now - heard_;
  const bool may_be_step = delivery_ == Delivery::direct || elapsed >= kSilence;
  const bool is_known = late_ && heard_ - near_ > kProof && !may_be_step;
  const Duration known_age = is_known ? *late_ : Duration{};
  const Duration lag = now - stamp;
  const bool went_back = stamp < newest_stamp_;
  const bool is_repeat = is_repeated(stamp);
  follow_drift(now);
  heard_ = now;
  if (lag < least_ - kSooner - drift_over(elapsed) * 2 || (!is_proven_ && went_back && !is_repeat)) {
    const bool was_proven = is_proven_;
    begin(now, stamp, was_proven ? known_age : Duration{});
    return {{}, StampFault::unproven, was_proven};
  }
  least_ = std::min(least_, lag);
  StampAge seen{lag - least_};
  const bool is_apart = seen.age > kNear;
  if (!is_proven_) {
    is_proven_ = proves(proof_, now, lag);
    newest_stamp_ = stamp;
    if (!is_proven_) seen.fault = StampFault::unproven;
  } else {
    if (went_back) seen.fault = StampFault::overtaken;
    if (is_apart && is_repeat) return seen;
    if (is_apart && (jump_ || went_back || may_be_step)) return after_jump(now, stamp, seen, known_age);
    jump_.reset();
    newest_stamp_ = std::max(newest_stamp_, stamp);
  }
  if (is_apart) {
    late_ = std::min(late_.value_or(seen.age), seen.age);
  } else {
    late_.reset();
    near_ = now;
  }
  return seen;
}

StampAge ForeignClock::after_jump(Time now, Time stamp, StampAge seen, Duration known_age) {
  if (!jump_) {
    jump_.emplace();
    age_before_jump_ = known_age;
  }
  if (seen.fault == StampFault::none) seen.fault = StampFault::unproven;
  const Duration lag = now - stamp;
  if (!proves(*jump_, now, lag)) return seen;
  least_ = jump_->least - age_before_jump_;
  near_ = now;
  newest_stamp_ = stamp;
  jump_.reset();
  return {lag - least_, StampFault::none, true};
}

StampAges::Writer& StampAges::writer_of(Time now, const StampSource& source) {
  auto writer = std::ranges::find(writers_, source.writer, &Writer::id);
  if (writer == writers_.end()) {
    if (writers_.size() == kWriters) writers_.erase(std::ranges::min_element(writers_, {}, &Writer::heard));
    writer = writers_.insert(writers_.end(), {.id = source.writer});
    writer->heard = now;
    writer->is_own_clock = source.is_own_clock;
  }
  // The component's clock went back, or the host's was set: what was known is of another time.
  if (now < writer->heard || writer->is_own_clock != source.is_own_clock)
    *writer = {.id = source.writer, .is_own_clock = source.is_own_clock};
  writer->heard = now;
  return *writer;
}

StampAge StampAges::add(Time now, Time stamp, const StampSource& source, Duration limit) {
  Writer& writer = writer_of(now, source);
  StampAge seen;
  if (source.is_own_clock) {
    seen.age = std::max(Duration{}, now - stamp);
    if (stamp > now + kFuture) return {{}, StampFault::future};
    if (writer.newest && stamp < *writer.newest) seen.fault = StampFault::overtaken;
    writer.newest = std::max(writer.newest.value_or(stamp), stamp);
  } else {
    seen = writer.clock.add(now, stamp);
    seen.age = seen.age + source.delay;
  }
  if (seen.fault == StampFault::none && seen.age > limit) seen.fault = StampFault::late;
  return seen;
}

}  // namespace bw
