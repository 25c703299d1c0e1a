// Speaks to an RPLIDAR over its cable: stop, who are you, how are you, motor, scan; again from the start
// whenever the cable was opened anew or the device fell silent. Never blocks and knows no clock: it is asked
// every few milliseconds.
//
//   closed -> quiet (what is under way is thrown away) -> info -> health -> sample times -> scan asked for ->
//   scanning
//
// Any of info, health and scan that is not answered within 0.5 s begins from quiet; every third time with a
// reset of the firmware.
// Nothing rotates before the device has said which one it is.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/laser/revolution.hpp"
#include "components/laser/rplidar/answers.hpp"
#include "runtime/base/byte_link.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw::laser {

struct RplidarOptions {
  Model model = Model::automatic;
  bool flip = false;
  /// [Hz] fewer revolutions per second are warned of (set by code alone)
  double rate_min = 4.0;
  int motor_pwm = 600;
  int motor_rpm = 600;

  template <class Visitor>
  void fields(Visitor& v) {
    v("model", model, {.doc = "family that must answer; auto: any. It decides what the motor hangs on"});
    v("flip", flip, {.doc = "mounted head first"});
    v("motor_pwm", motor_pwm, {.min = 0, .max = 1023, .doc = "speed of the motor, a2 and a3"});
    v("motor_rpm", motor_rpm, {.unit = "1/min", .min = 0, .max = 1500, .doc = "speed of the motor, s"});
    v.retired({"rate_min"}, "a constant of rplidar.hpp");
  }
};

struct RplidarStatus {
  enum class Level : std::uint8_t { good, warning, error };
  Level level = Level::warning;
  bool is_starting = false;  ///< a warning that is in the course of things
  std::string text;          ///< for people
  double rate = 0.0;         ///< of the last revolution [Hz]; 0: none came lately
  std::size_t points = 0;    ///< in it
  std::map<std::string, std::uint64_t> counters;
};

class Rplidar {
 public:
  Rplidar(const RplidarOptions& options, ByteLink& link);

  /// The revolutions that ended since the last call.
  std::vector<Revolution> poll(Time now);
  /// Stops scan and motor; the cable may be gone.
  void stop(Time now);

  /// Of the last poll. An error: no scans come, or they may not be relied on.
  RplidarStatus status() const;
  const std::optional<Info>& info() const { return info_; }

 private:
  enum class State : std::uint8_t { closed, quiet, info, health, sample_times, scan, scanning, refused };

  void begin(Time now);
  void enter(State state, Time now, Duration patience);
  void send(Command command);
  void take_in(Time now, const Received& received);
  void on_info(Time now, const Info& info);
  void on_health(Time now, const Health& health);
  void start_scan(Time now);
  void set_motor(bool runs);
  void add_nodes(Time now, const std::vector<Node>& nodes);
  void on_revolution(Time now, Revolution revolution);
  /// The state's time is over.
  void run_out(Time now);
  void look_for_silence(Time now);
  std::string waiting_text() const;

  RplidarOptions options_;
  ByteLink& link_;
  AnswerReader reader_;
  RevolutionCollector collector_;
  State state_ = State::closed;
  Time entered_;
  Time until_;
  std::optional<Time> polled_;
  std::uint64_t openings_ = 0;
  int attempts_ = 0;        ///< since the cable was opened or a scan came
  bool has_heard_ = false;  ///< any byte in these attempts
  std::optional<Info> info_;
  std::optional<Health> health_;
  Duration sample_time_;
  Time last_bytes_;  ///< when the last came
  std::uint64_t nodes_of_scan_ = 0;
  std::optional<Time> last_revolution_;
  double rate_ = 0.0;
  std::size_t points_ = 0;
  bool is_silent_ = false;
  std::uint64_t restarts_ = 0, resets_ = 0, silences_ = 0, revolutions_ = 0;
  std::string refusal_;
  std::string closed_why_;
  bool is_opening_ = true;  ///< closed, and nothing is wrong with that so far
  std::vector<Revolution> over_;
};

}  // namespace bw::laser
