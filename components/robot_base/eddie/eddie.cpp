#include "components/robot_base/eddie/eddie.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "components/robot_base/eddie/rangers.hpp"
#include "components/robot_base/wrapping_counts.hpp"

namespace bw::eddie {
namespace {

constexpr Duration kListen = Duration::milliseconds(80);           ///< after the first bytes of a session
constexpr Duration kSilentStrange = Duration::milliseconds(1000);  ///< without an answer
constexpr Duration kSilentGivenUp = Duration::milliseconds(4000);
constexpr Duration kSayAgain = Duration::milliseconds(100);   ///< what GOSPD said, though nothing changed
constexpr Duration kStartAnew = Duration::milliseconds(500);  ///< of silence: the board may have restarted
constexpr int kFewerPositions = 100;  ///< a revolution of the wheel: the older board, whose ACC goes to FF

WheelSpeeds metres_per_count(const Robot& robot) {
  const WheelRadii radii = robot.wheel_radii();
  return {robot.metres_per_tick(radii.left), robot.metres_per_tick(radii.right)};
}

Duration period(double rate) { return Duration::seconds(1.0 / rate); }

Time middle(const Reply& reply) {
  return reply.sent + Duration{(reply.arrived - reply.sent).nanoseconds / 2};
}

}  // namespace

Eddie::Eddie(const EddieOptions& options, const Robot& robot, std::unique_ptr<ByteLink> link)
    : options_(options),
      metres_per_count_(metres_per_count(robot)),
      reach_(3.0 * robot.wheel_speed_max),
      link_(std::move(link)),
      dialogue_(Duration::seconds(options.reply_timeout)),
      check_(std::max(metres_per_count_.left, metres_per_count_.right), options.acceleration) {
  is_coarse_ = robot.ticks_per_revolution < kFewerPositions;
  tasks_ = {{Request::drive, period(options.rates.drive), {}},
            {Request::counts, period(options.rates.counts), {}},
            {Request::analog, period(options.rates.analog), {}}};
  if (!options.sonar_pins.empty()) tasks_.push_back({Request::sonar, period(options.rates.sonar), {}});
}

std::vector<Ranger> Eddie::rangers() const { return rangers_of(options_); }

BaseFacts Eddie::facts() const {
  return {.has_battery = true,
          .response = 0.25,
          .velocity_window = options_.velocity_window,
          .battery_low = options_.kBatteryLow,
          .battery_empty = options_.kBatteryEmpty};
}

void Eddie::begin_session(Time now) {
  phase_ = Phase::opened;
  began_ = now;
  heard_.reset();
  start_step_ = 0;
  has_watch_ = true;
  settings_refused_.clear();
  drive_refusals_ = 0;
  was_sent_ = false;
  target_ = sent_ = {};
  check_.reset();
  unknown_device_.reset();
  for (Task& task : tasks_) task.asked.reset();
  ++starts_;
}

Readings Eddie::poll(Time now) {
  Readings readings;
  const LinkState& link = link_->update(now);
  if (link.is_open && link.openings != openings_) {
    openings_ = link.openings;
    begin_session(now);
  }
  const std::span<const std::uint8_t> bytes = link_->read();
  unknown_device_.add(bytes);
  const std::optional<Reply> reply = dialogue_.take(now, bytes);
  if (reply && phase_ != Phase::closed && phase_ != Phase::opened) take(now, *reply, readings);
  readings.link = heard(now, link);
  tell(now, readings);
  return readings;
}

void Eddie::take(Time now, const Reply& reply, Readings& readings) {
  if (phase_ == Phase::starting) return take_start(now, reply);
  if (reply.is_timeout) return;
  if (const auto reason = error_of(reply.text)) {
    refused(now, reply, *reason);
  } else if (!take_running(now, reply, readings)) {
    ++malformed_;
    dialogue_.refuse(now);
    return;
  }
  heard_ = now;
  unknown_device_.reset();
}

/// One step of the start after the other; without the answers to STOP and VER there is no Eddie, and it
/// begins again.
void Eddie::take_start(Time now, const Reply& reply) {
  const auto reason = error_of(reply.text);
  const bool is_version = reply.request == Request::version || reply.request == Request::hardware;
  const auto numbers = is_version ? numbers_of(reply.text, 4) : std::nullopt;
  const bool has_number = numbers && numbers->size() == 1;
  const bool is_question = reply.request == Request::reason;  // any error will do
  const bool is_needed = reply.request == Request::stop || reply.request == Request::version;
  const bool is_sound = !reply.is_timeout && (reason       ? !is_needed
                                              : is_version ? has_number
                                                           : reply.text.empty());
  if (!is_sound) {
    start_step_ = 0;
    if (!reply.is_timeout) {
      ++malformed_;
      dialogue_.refuse(now);
    }
    return;
  }
  if (is_question) {
    take_mark(now, reason && !reason->empty());
  } else if (reason) {
    ++errors_;
    if (reply.request == Request::watch) {
      has_watch_ = false;
    } else if (reply.request != Request::verbose && reply.request != Request::hardware) {
      const std::string text = text_of(reply.request);
      settings_refused_ = "the board refuses " + text.substr(0, text.size() - 1) + " (" + *reason + ")";
    }
  } else if (has_number) {
    (reply.request == Request::version ? version_ : hardware_) = numbers->front();
  }
  unknown_device_.reset();
  if (++start_step_ < start_sequence().size()) return;
  phase_ = Phase::running;
  heard_ = now;
}

/// VERB 1 is forgotten when the board loses its power, and its counts are: the same error then has no reason
/// any more.
void Eddie::take_mark(Time now, bool has_reason) {
  if (start_sequence().at(start_step_ - 1) == Request::verbose) {
    is_marked_ = has_reason;
    return;
  }
  if (!is_marked_ || has_reason || !distances_) return;
  is_marked_ = false;
  has_restarted_ = true;
  ++restarts_;
  faults_.say(now, "counts",
              "the board restarted while it was not heard: how far its wheels turned meanwhile is not known");
}

bool Eddie::take_running(Time now, const Reply& reply, Readings& readings) {
  if (reply.request == Request::counts) return take_counts(now, reply, readings);
  if (reply.request == Request::analog) return take_analog(reply, readings);
  if (reply.request == Request::sonar) return take_sonar(reply, readings);
  if (!reply.text.empty()) return false;
  drive_refusals_ = 0;
  check_.told(now, ground_speeds(sent_));
  return true;
}

bool Eddie::take_counts(Time now, const Reply& reply, Readings& readings) {
  const auto distances = distances_of(reply.text);
  if (!distances) return false;
  // It lay there while this computer was held up: when it was counted is not known, and the next one tells as
  // much.
  if (reply.arrived - reply.sent > Duration::seconds(options_.reply_timeout)) return true;
  const Time time = middle(reply);
  if (has_restarted_) {
    base_ = {wrapping_difference(distances->left, wrapping_sum(distances_->left, base_.left)),
             wrapping_difference(distances->right, wrapping_sum(distances_->right, base_.right))};
    distances_.reset();
    has_restarted_ = false;
  }
  const auto old = std::exchange(distances_, distances);
  if (old) {
    const double seconds = std::max(0.0, (time - distances_time_).to_seconds());
    const double most = std::max(wrapping_distance(old->left, distances->left),
                                 wrapping_distance(old->right, distances->right));
    if (most > 50.0 + reach_ * seconds / std::min(metres_per_count_.left, metres_per_count_.right)) {
      ++jumps_;
      check_.reset();
      faults_.say(now, "counts",
                  "DIST jumped by " + std::to_string(std::lround(most)) + " positions in " +
                      std::to_string(std::lround(seconds * 1e3)) +
                      " ms: the board restarted, or a line is damaged");
    }
  }
  distances_time_ = time;
  readings.counts.push_back(
      {time, wrapping_sum(distances->left, base_.left), wrapping_sum(distances->right, base_.right)});
  const WheelSpeeds travel = {distances->left * metres_per_count_.left,
                              distances->right * metres_per_count_.right};
  const std::string contradiction = check_.measured(time, travel);
  if (contradiction.empty()) return true;
  ++contradictions_;
  faults_.say(now, "contradiction", contradiction);
  return true;
}

bool Eddie::take_analog(const Reply& reply, Readings& readings) const {
  const auto values = numbers_of(reply.text, 3);
  if (!values || values->size() != kAnalogChannels) return false;
  readings.battery = BatteryReading{.voltage = (*values)[kSupplyChannel] * options_.supply_volts_per_unit};
  add_infrared(middle(reply), *values, options_, readings.ranges);
  return true;
}

bool Eddie::take_sonar(const Reply& reply, Readings& readings) const {
  const auto values = numbers_of(reply.text, 3);
  if (!values || values->size() != options_.sonar_pins.size()) return false;
  add_sonar(middle(reply), *values, options_, readings.ranges);
  return true;
}

/// A line may be damaged on its way; three in a row are not.
void Eddie::refused(Time now, const Reply& reply, const std::string& reason) {
  constexpr int kInARow = 3;
  ++errors_;
  if (reply.request != Request::drive || ++drive_refusals_ < kInARow) return;
  std::string text = text_of(Request::drive);
  text.pop_back();
  faults_.say(now, "refused", "the board refuses " + text + (reason.empty() ? "" : ": " + reason));
}

/// The cable's state; one on which no Eddie answers counts as not open.
LinkState Eddie::heard(Time now, const LinkState& cable) {
  LinkState link = cable;
  if (!link.is_open) {
    phase_ = Phase::closed;
    return link;
  }
  if (heard_ && *heard_ > now) heard_ = now;
  if (began_ > now) began_ = now;
  const Duration silence = now - heard_.value_or(began_);
  if (phase_ == Phase::running && silence < Duration::seconds(options_.silence)) return link;
  link.is_open = false;
  link.fault = phase_ == Phase::running ? "no answer of the board" : "not answered as an Eddie yet";
  if (phase_ == Phase::running && silence >= kStartAnew) begin_session(now);
  if (silence < kSilentStrange) return link;
  link.fault = "no answer of an Eddie to STOP and VER";
  if (!unknown_device_.is_heard()) {
    link.fault += ": nothing comes; is the board switched on?";
    return link;
  }
  link.fault += ", but bytes: " + unknown_device_.likeness();
  faults_.say(now, "stranger", link.fault);
  if (silence >= kSilentGivenUp) {
    link_->close(now, link.fault);
    phase_ = Phase::closed;
  }
  return link;
}

void Eddie::tell(Time now, Readings& readings) {
  readings.fault = faults_.text(now);
  if (!has_watch_)
    readings.warning =
        "the board's firmware has no WATCH: it drives on when the cable is pulled or the computer dies";
  if (!settings_refused_.empty())
    readings.warning += (readings.warning.empty() ? "" : "; ") + settings_refused_;
}

std::map<std::string, std::uint64_t> Eddie::counters() const {
  const DialogueCounts& counts = dialogue_.counts();
  std::map<std::string, std::uint64_t> all = {{"replies", counts.replies},
                                              {"timeouts", counts.timeouts},
                                              {"unexpected lines", counts.unexpected_lines},
                                              {"bytes thrown away", counts.bytes_thrown_away},
                                              {"malformed replies", malformed_},
                                              {"errors", errors_},
                                              {"encoder jumps", jumps_},
                                              {"contradictions", contradictions_},
                                              {"restarts", restarts_},
                                              {"starts", starts_}};
  if (version_) all["firmware version"] = *version_;
  if (hardware_) all["hardware version"] = *hardware_;
  return all;
}

std::vector<Request> Eddie::start_sequence() const {
  std::vector<Request> sequence = {Request::stop,   Request::reason,      Request::verbose,
                                   Request::reason, Request::version,     Request::hardware,
                                   Request::watch,  Request::acceleration};
  if (!options_.sonar_pins.empty()) sequence.push_back(Request::sonars);
  return sequence;
}

std::string Eddie::text_of(Request request) const {
  switch (request) {
    case Request::stop:
      return eddie::command("STOP", {0});
    case Request::reason:
      return eddie::command("VERB");  // too few parameters: an error that changes nothing
    case Request::verbose:
      return eddie::command("VERB", {1});
    case Request::version:
      return eddie::command("VER");
    case Request::hardware:
      return eddie::command("HWVER");
    case Request::watch:
      return eddie::command("WATCH", {options_.watch ? 1 : 0});
    case Request::acceleration: {
      const double counts = options_.acceleration / std::min(metres_per_count_.left, metres_per_count_.right);
      return eddie::command("ACC", {to_word(std::clamp(counts, 1.0, is_coarse_ ? 255.0 : 2047.0))});
    }
    case Request::sonars: {
      int mask = 0;
      for (const std::int64_t pin : options_.sonar_pins) mask |= 1 << pin;
      return eddie::command("SPNG", {mask});
    }
    case Request::drive:
      return eddie::command("GOSPD", {sent_.left, sent_.right});
    case Request::counts:
      return eddie::command("DIST");
    case Request::analog:
      return eddie::command("ADC");
    case Request::sonar:
      return eddie::command("PING");
  }
  return {};
}

Eddie::Target Eddie::target_of(const WheelSpeeds& wheels) const {
  const double share = options_.positions_per == PositionsPer::second ? 1.0 : 0.5;
  if (!std::isfinite(wheels.left) || !std::isfinite(wheels.right)) return {};
  return {to_word(share * wheels.left / metres_per_count_.left),
          to_word(share * wheels.right / metres_per_count_.right)};
}

WheelSpeeds Eddie::ground_speeds(const Target& target) const {
  const double share = options_.positions_per == PositionsPer::second ? 1.0 : 0.5;
  return {target.left * metres_per_count_.left / share, target.right * metres_per_count_.right / share};
}

/// What is most overdue by its own period; a stop before all.
std::optional<Request> Eddie::next(Time now) {
  if (phase_ == Phase::starting) return start_sequence().at(start_step_);
  if (target_ == Target{} && (!was_sent_ || sent_ != target_)) return Request::drive;
  const Task* chosen = nullptr;
  double most = 0.0;
  for (Task& task : tasks_) {
    if (task.asked && *task.asked > now) task.asked.reset();
    const bool is_repetition = task.request == Request::drive && target_ == sent_;
    const Duration period = is_repetition ? std::max(task.period, kSayAgain) : task.period;
    const double due = task.asked ? (now - *task.asked).to_seconds() / period.to_seconds() : 1e9;
    if (due < 1.0 - 1e-9 || due <= most) continue;
    most = due;
    chosen = &task;
  }
  return chosen == nullptr ? std::nullopt : std::optional(chosen->request);
}

bool Eddie::command(Time now, const WheelSpeeds& wheels) {
  target_ = phase_ == Phase::running ? target_of(wheels) : Target{};
  if (phase_ == Phase::closed) return false;
  if (phase_ == Phase::opened) {
    // Its letters make an error of half a line that the board may still hold, and no motion.
    dialogue_.begin(now, kListen);
    const std::string stop = text_of(Request::stop);
    if (link_->write({reinterpret_cast<const std::uint8_t*>(stop.data()), stop.size()}))
      phase_ = Phase::starting;
    return false;
  }
  if (dialogue_.is_free(now)) {
    const std::optional<Request> request = next(now);
    if (request) {
      if (*request == Request::drive) sent_ = target_;
      if (!dialogue_.ask(now, *request, text_of(*request), *link_)) return false;
      if (*request == Request::drive) was_sent_ = true;
      for (Task& task : tasks_)
        if (task.request == *request) task.asked = now;
    }
  }
  return phase_ == Phase::running;
}

void Eddie::stop(Time) {
  if (phase_ == Phase::closed) return;
  target_ = {};
  const std::string text = text_of(Request::stop);
  if (link_->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()})) link_->rest();
}

std::vector<std::uint8_t> Eddie::stop_frame() {
  const std::string one = eddie::command("STOP", {0}), text = one + one;
  return {text.begin(), text.end()};
}

}  // namespace bw::eddie
