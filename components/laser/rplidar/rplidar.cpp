#include "components/laser/rplidar/rplidar.hpp"

#include <utility>

namespace bw::laser {
namespace {

constexpr Duration kQuiet = Duration::milliseconds(60);      // what a stopped device still had under way
constexpr Duration kAnswer = Duration::milliseconds(500);    // for an answer, and for nodes to go on
constexpr Duration kOptional = Duration::milliseconds(200);  // old firmware knows no sample times
constexpr Duration kSilence = Duration::milliseconds(250);   // told as an error; 2000 nodes come in a second
constexpr Duration kSpinUp = Duration::milliseconds(5000);   // no nodes before the head rotates steadily
constexpr Duration kReset = Duration::milliseconds(1000);    // the firmware starts
constexpr Duration kStandstill = Duration::milliseconds(1000);  // nodes without a revolution: the head stands
constexpr Duration kRefused = Duration::milliseconds(2000);     // until another device may be there
constexpr Duration kLegacySampleTime = {476'000};               // of firmware that does not tell its own [ns]
constexpr int kAttemptsToReset = 3;

std::string one_decimal(double value) {
  const auto tenths = static_cast<std::int64_t>(value * 10.0 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

Rplidar::Rplidar(const RplidarOptions& options, ByteLink& link)
    : options_(options), link_(link), collector_(options.flip), sample_time_(kLegacySampleTime) {}

std::vector<Revolution> Rplidar::poll(Time now) {
  over_.clear();
  const LinkState& link = link_.update(now);
  const bool clock_went_back = polled_ && now < *polled_;
  polled_ = now;
  if (!link.is_open) {
    state_ = State::closed;
    rate_ = 0.0;
    closed_why_ = link.fault;
    is_opening_ = link.is_opening;
    return {};
  }
  if (state_ == State::closed || link.openings != openings_ || clock_went_back) {
    openings_ = link.openings;
    attempts_ = 0;
    has_heard_ = false;
    info_.reset();
    begin(now);
  }
  const auto bytes = link_.read();
  if (!bytes.empty()) {
    last_bytes_ = now;
    has_heard_ = true;
    if (state_ != State::quiet && state_ != State::refused) take_in(now, reader_.read(bytes));
  }
  if (state_ == State::scanning) look_for_silence(now);
  if (state_ != State::scanning && now >= until_) run_out(now);
  return std::exchange(over_, {});
}

void Rplidar::stop(Time now) {
  if (state_ == State::closed) return;
  send(Command::stop);
  set_motor(false);
  enter(State::quiet, now, kQuiet);
}

void Rplidar::begin(Time now) {
  send(Command::stop);
  const bool needs_reset = attempts_ > 0 && attempts_ % kAttemptsToReset == 0;
  if (needs_reset) {
    send(Command::reset);
    ++resets_;
  }
  rate_ = 0.0;
  is_silent_ = false;
  collector_.restart();
  enter(State::quiet, now, needs_reset ? kReset : kQuiet);
}

void Rplidar::enter(State state, Time now, Duration patience) {
  state_ = state;
  entered_ = now;
  until_ = now + patience;
}

void Rplidar::send(Command command) { static_cast<void>(link_.write(request(command))); }

void Rplidar::take_in(Time now, const Received& received) {
  if (received.info && state_ == State::info) on_info(now, *received.info);
  if (received.health && state_ == State::health) on_health(now, *received.health);
  if (received.sample_time && state_ == State::sample_times) {
    const bool is_sound =
        *received.sample_time > Duration{} && *received.sample_time < Duration::milliseconds(10);
    sample_time_ = is_sound ? *received.sample_time : kLegacySampleTime;
    start_scan(now);
  }
  if (received.scan_begins && state_ == State::scan) {
    enter(State::scanning, now, kSpinUp);
    last_revolution_.reset();
    nodes_of_scan_ = 0;
  }
  if (state_ == State::scanning) add_nodes(now, received.nodes);
}

void Rplidar::on_info(Time now, const Info& info) {
  info_ = info;
  const std::optional<Model> family = info.family();
  const bool is_right = family && (options_.model == Model::automatic || *family == options_.model);
  if (is_right) {
    send(Command::health);
    enter(State::health, now, kAnswer);
    return;
  }
  refusal_ = "the device says that it is " + info.text();
  if (options_.model != Model::automatic)
    refusal_ += ", and the robot file wants model " + std::string(text_of(options_.model));
  enter(State::refused, now, kRefused);
}

void Rplidar::on_health(Time now, const Health& health) {
  health_ = health;
  if (health.status == Health::Status::error) {
    ++restarts_;
    attempts_ = kAttemptsToReset;  // a reset is all that helps
    return begin(now);
  }
  send(Command::sample_times);
  enter(State::sample_times, now, kOptional);
}

void Rplidar::start_scan(Time now) {
  set_motor(true);
  send(Command::scan);
  enter(State::scan, now, kAnswer);
}

void Rplidar::set_motor(bool runs) {
  if (!info_) return;
  const auto pwm = static_cast<std::uint16_t>(runs ? options_.motor_pwm : 0);
  const auto rpm = static_cast<std::uint16_t>(runs ? options_.motor_rpm : 0);
  switch (info_->family().value_or(Model::automatic)) {
    case Model::a1:  // cleared: it rotates; where there is no such line it rotates with the power
      static_cast<void>(link_.set_dtr(!runs));
      break;
    case Model::a2:
    case Model::a3:
      static_cast<void>(link_.write(request(Command::motor_pwm, pwm)));
      break;
    case Model::s:
      static_cast<void>(link_.write(request(Command::motor_rpm, rpm)));
      break;
    case Model::c1:  // rotates while it scans
    case Model::automatic:
      break;
  }
}

void Rplidar::add_nodes(Time now, const std::vector<Node>& nodes) {
  auto still_to_come = static_cast<std::int64_t>(nodes.size());
  nodes_of_scan_ += nodes.size();
  for (const Node& node : nodes) {
    --still_to_come;
    if (auto over = collector_.add(node, now - sample_time_ * still_to_come))
      on_revolution(now, *std::move(over));
  }
}

void Rplidar::on_revolution(Time now, Revolution revolution) {
  const Duration period = revolution.next - revolution.first;
  if (period <= Duration{} || revolution.samples.empty()) return;
  ++revolutions_;
  attempts_ = 0;
  last_revolution_ = now;
  rate_ = 1.0 / period.to_seconds();
  points_ = revolution.samples.size();
  over_.push_back(std::move(revolution));
}

void Rplidar::run_out(Time now) {
  switch (state_) {
    case State::quiet:
      reader_.restart();
      send(Command::info);
      return enter(State::info, now, kAnswer);
    case State::sample_times:
      sample_time_ = kLegacySampleTime;
      return start_scan(now);
    case State::refused:
    case State::info:
    case State::health:
    case State::scan:
      ++attempts_;
      ++restarts_;
      return begin(now);
    case State::closed:
    case State::scanning:
      return;
  }
}

void Rplidar::look_for_silence(Time now) {
  const bool has_nodes = nodes_of_scan_ > 0;
  const Duration silence = now - last_bytes_;
  if (has_nodes && silence >= kSilence && !std::exchange(is_silent_, true)) ++silences_;
  if (silence < kSilence) is_silent_ = false;
  if (silence >= (has_nodes ? kAnswer : kSpinUp)) {
    ++attempts_;
    ++restarts_;
    begin(now);
    is_silent_ = has_nodes;
  }
  if (last_revolution_ ? now - *last_revolution_ > kStandstill : now - entered_ > kSpinUp) rate_ = 0.0;
}

std::string Rplidar::waiting_text() const {
  if (state_ == State::scanning || state_ == State::scan) return "the head begins to turn";
  if (attempts_ == 0 && !is_silent_) return "asking who is there";
  if (!has_heard_) return "no answer: is it an RPLIDAR, and has it power?";
  return "what it sends is no answer: wrong baud, or no RPLIDAR? (a1, a2m8: 115200; a2m7, a2m12, a3: 256000; s2, s3: 1000000)";
}

RplidarStatus Rplidar::status() const {
  using Level = RplidarStatus::Level;
  RplidarStatus status{
      .level = Level::good, .text = "scanning", .rate = rate_, .points = rate_ > 0.0 ? points_ : 0};
  status.counters = {{"revolutions", revolutions_},
                     {"nodes", reader_.nodes().nodes},
                     {"losses_of_step", reader_.nodes().losses_of_step},
                     {"bytes_thrown_away", reader_.nodes().bytes_thrown_away + reader_.bytes_thrown_away()},
                     {"silences", silences_},
                     {"restarts", restarts_},
                     {"resets", resets_},
                     {"openings", openings_}};
  const auto say = [&status](Level level, std::string text) {
    status.level = level;
    status.text = std::move(text);
  };
  const auto say_waiting = [&] {
    say(attempts_ == 0 ? Level::warning : Level::error, waiting_text());
    status.is_starting = attempts_ == 0;
  };
  const auto say_opening = [&] {
    say(Level::warning, "being opened");
    status.is_starting = true;
  };
  const bool is_sick = health_ && health_->status != Health::Status::good;
  const std::string sickness = is_sick ? " (code " + std::to_string(health_->code) + ")" : "";
  if (state_ == State::closed) {
    say(Level::error, closed_why_.empty() ? "not open" : closed_why_);
    if (is_opening_) say_opening();
  } else if (state_ == State::refused) {
    say(Level::error, refusal_);
  } else if (is_sick && health_->status == Health::Status::error) {
    say(Level::error, "the device says that it is broken" + sickness);
  } else if (is_silent_) {
    say(Level::error, "silent");
  } else if (state_ != State::scanning) {
    say_waiting();
  } else if (rate_ == 0.0) {
    const bool stands = last_revolution_ || (polled_ && *polled_ - entered_ > kSpinUp);
    if (stands)
      say(Level::error, "the head does not turn");
    else
      say_waiting();
  } else if (rate_ < options_.rate_min) {
    say(Level::warning, "turns slower than " + one_decimal(options_.rate_min) + " Hz");
  } else if (is_sick) {
    say(Level::warning, "scanning; the device warns of itself" + sickness);
  }
  return status;
}

}  // namespace bw::laser
