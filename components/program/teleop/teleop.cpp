// `bandwagon teleop`: the robot by hand, on the keys of a terminal. It publishes `cmd_vel_teleop`, which
// twist_mux takes before the planner; the collision monitor and the base watch over a hand as over everybody.
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <fmt/format.h>
#include <geometry_msgs/msg/twist.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "components/program/teleop/dead_man.hpp"
#include "components/program/teleop/robot_in_words.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/terminal.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/host/statistics.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/ros/typed_topic.hpp"

namespace bw {
namespace {

using cli::Key;
using std_srvs::srv::Trigger;

constexpr Duration kPeriod = Duration::milliseconds(50);
constexpr Duration kUntilInForce = Duration::milliseconds(300);  ///< from the key to base_state
constexpr int kZeros = 3;  ///< after a motion: one may be lost, and then the hand is silent

constexpr const char* kHelp =
    R"(        u   up   o            w, s, a, d and the arrows drive and turn, u and o on an arc
       left     right         + and - change the speed, SPACE stops
           down               x EMERGENCY STOP, R and then y releases it and all other latches,
                              and lets a goal go on that you interrupted
The robot drives while a key is held: it stops 0.2 s after the last one, and once between the first and the
moment at which the keyboard begins to repeat it. q or Ctrl-C ends.
)";

struct TeleopOptions {
  double v = 0.3;
  double omega = 0.8;
  std::string ns;
};

std::optional<Direction> direction_of(Key key) {
  switch (key) {
    case cli::kUp:
    case 'w':
      return Direction{.forward = 1};
    case cli::kDown:
    case 's':
      return Direction{.forward = -1};
    case cli::kLeft:
    case 'a':
      return Direction{.rotation = 1};
    case cli::kRight:
    case 'd':
      return Direction{.rotation = -1};
    case 'u':
      return Direction{.forward = 1, .rotation = 1};
    case 'o':
      return Direction{.forward = 1, .rotation = -1};
    default:
      return std::nullopt;
  }
}

class Teleop {
 public:
  explicit Teleop(const TeleopOptions& options)
      : hand_({.v = options.v, .omega = options.omega}),
        participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}),
        commands_(participant_, name(options, "cmd_vel_teleop"), Qos::command()),
        emergency_(participant_, name(options, "emergency_stop"), Qos::standard()),
        odometry_(participant_, name(options, "odom")),
        state_(participant_, name(options, "base_state")),
        override_(participant_, name(options, "manual_override"), Qos::latched()),
        release_(participant_, name(options, "release_stop"), service_type<Trigger>(), [] {}) {}

  /// Ends at rest, whatever ended it.
  ~Teleop() {
    if (!has_driven_) return;
    for (int i = 0; i < kZeros; ++i) publish({});
    commands_.flush(Duration::milliseconds(500));
  }
  Teleop(const Teleop&) = delete;
  Teleop& operator=(const Teleop&) = delete;

  /// Until somebody ends it; the exit status.
  int drive(cli::Keyboard& keyboard, cli::ProgressLine& line) {
    for (Time due = now(); !cli::interrupted();) {
      step();
      line.show(in_one_line());
      if (due <= now()) due = now() + kPeriod;
      const Time wake = hand_.is_driving(now()) ? std::min(due, *hand_.until()) : due;
      const std::optional<Key> key = keyboard.wait(wake - now());
      if (!keyboard.is_there()) return 1;
      if (key && !obey(*key)) return 0;
    }
    return 0;
  }

 private:
  static Time now() { return {steady_time().nanoseconds}; }
  static std::string name(const TeleopOptions& options, const std::string& topic) {
    return join_namespaces(join_namespaces("/", options.ns), topic);
  }

  void publish(const Twist2& twist) {
    geometry_msgs::msg::Twist message;
    message.linear().x(twist.v);
    message.angular().z(twist.omega);
    commands_.publish(message);
  }

  /// At 20 Hz while a key is held, and zero at once when it is let go.
  void step() {
    const Time t = now();
    const bool is_driving = hand_.is_driving(t);
    const bool is_change = hand_.twist(t) != sent_;
    if (is_change || t - sent_at_ >= kPeriod) {
      if (is_driving) zeros_owed_ = kZeros;
      if (is_driving || zeros_owed_-- > 0) publish(sent_ = hand_.twist(t));
      zeros_owed_ = std::max(zeros_owed_, 0);
      has_driven_ = has_driven_ || is_driving;
      sent_at_ = t;
    }
    if (auto odometry = odometry_.take_newest())
      measured_ = Twist2{odometry->twist().twist().linear().x(), odometry->twist().twist().angular().z()};
    if (auto state = state_.take_newest()) base_ = std::move(state);
    if (auto override = override_.take_newest()) is_interrupted_ = override->data();
    if (stopping_since_) see_stop(t);
    if (release_at_ && t >= *release_at_) ask_for_release();
    if (asked_) hear_release();
  }

  /// False: the end.
  bool obey(Key key) {
    const bool is_confirmed = is_release_asked_ && key == 'y';
    is_release_asked_ = false;
    if (is_confirmed) {
      release();
      return true;
    }
    said_.clear();
    if (const auto direction = direction_of(key)) {
      hand_.press(now(), *direction);
      return true;
    }
    hand_.let_go();
    switch (key) {
      case 'q':
      case '\x04':  // Ctrl-D
        return false;
      case '+':
      case '=':
        hand_.change_speed(+1);
        break;
      case '-':
        hand_.change_speed(-1);
        break;
      case 'x':
        stop_at_once();
        break;
      case 'R':
        is_release_asked_ = true;
        said_ = "Is the way free? y releases all stops";
        break;
      default:
        break;
    }
    return true;
  }

  void stop(bool is_pressed) {
    std_msgs::msg::Bool message;
    message.data(is_pressed);
    emergency_.publish(message);
  }

  void stop_at_once() {
    publish({});
    base_.reset();  // what it says from now on counts
    stopping_since_ = now();
    see_stop(*stopping_since_);
  }

  /// That somebody has a reader says nothing: the base itself tells that it is latched. Until then it is said
  /// again.
  void see_stop(Time t) {
    namespace base = bandwagon_msgs::msg::BaseState_Constants;
    if (base_ && base_->state() == base::EMERGENCY_STOP && base_->is_latched()) {
      said_ = "the emergency stop is in force";
      return stopping_since_.reset();
    }
    stop(true);
    said_ = t - *stopping_since_ < kUntilInForce
                ? "emergency stop"
                : "NOT STOPPED: base_state tells of no emergency stop; use the switch of the base";
  }

  /// The switch is pulled out first, and heard: what is still pressed is not released.
  void release() {
    stopping_since_.reset();
    stop(false);
    release_at_ = now() + Duration::milliseconds(100);
    said_ = "releasing";
  }

  void ask_for_release() {
    release_at_.reset();
    std::vector<std::uint8_t> request;
    serialize(Trigger::Request{}, request);
    asked_ = release_.is_ready() ? release_.send(request) : std::nullopt;
    if (!asked_) said_ = "nobody offers release_stop";
  }

  void hear_release() {
    const auto reply = release_.take(*asked_);
    Trigger::Response response;
    if (!reply || !deserialize(*reply, response)) return;
    asked_.reset();
    said_ = (response.success() ? "released" : "not released") +
            (response.message().empty() ? "" : ": " + response.message());
  }

  std::string in_one_line() const {
    const std::string robot = measured_ ? "robot " + in_words(*measured_) : "no odom is heard";
    const std::string ear = commands_.readers() > 0 ? "" : " | nobody hears cmd_vel_teleop";
    const std::string waits = is_interrupted_ ? " | a goal waits (R lets it go on)" : "";
    return fmt::format("{:3.0f} % | hand {} | {} | {}{}{}{}{}", hand_.share() * 100.0,
                       in_words(hand_.twist(now())), robot, in_words(base_), waits, ear,
                       said_.empty() ? "" : " | ", said_);
  }

  DeadMan hand_;
  dds::Participant participant_;
  TopicWriter<geometry_msgs::msg::Twist> commands_;
  TopicWriter<std_msgs::msg::Bool> emergency_;
  TopicReader<nav_msgs::msg::Odometry> odometry_;
  TopicReader<bandwagon_msgs::msg::BaseState> state_;
  TopicReader<std_msgs::msg::Bool> override_;
  ServiceCaller release_;
  Twist2 sent_;
  Time sent_at_;
  int zeros_owed_ = 0;
  bool has_driven_ = false;
  bool is_interrupted_ = false;  ///< somebody whom a hand took over from waits for a release
  std::optional<Twist2> measured_;
  std::optional<bandwagon_msgs::msg::BaseState> base_;
  bool is_release_asked_ = false;
  std::optional<Time> stopping_since_;  ///< x was pressed, and the base has not said that it is stopped
  std::optional<Time> release_at_;
  std::optional<std::int64_t> asked_;
  std::string said_;
};

int teleop(const TeleopOptions& options) {
  cli::catch_interrupts();
  cli::Keyboard keyboard;
  if (!keyboard.is_there())
    throw std::runtime_error(
        "teleop needs the keys of a terminal, in the foreground: a pipe tells nothing of a hand");
  std::cout << fmt::format("Drives at up to {:.2f} m/s and {:.2f} rad/s over {}.\n", options.v, options.omega,
                           join_namespaces(join_namespaces("/", options.ns), "cmd_vel_teleop"))
            << kHelp << std::flush;
  cli::ProgressLine line;
  return Teleop(options).drive(keyboard, line);
}

void add_teleop(cli::Verb verb) {
  auto options = std::make_shared<TeleopOptions>();
  verb.option("--v", options->v, "Speed at 100 % [m/s]; it begins with 50 %")
      .within(0.01, 2.0)
      .shows_default();
  verb.option("--omega", options->omega, "Turn rate at 100 % [rad/s]").within(0.01, 4.0).shows_default();
  verb.option("--namespace", options->ns, "Of the robot, among several");
  verb.run([options] { return teleop(*options); });
}

}  // namespace

BW_VERB(drive, "teleop", "Drives a robot by hand, on the keys of this terminal", add_teleop)

}  // namespace bw
