// Every sequence of what three sources say, what a clock does and how time passes, judged by a second
// description of the rules of README: who may be heard, and how long the robot may go on after the last word.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "components/twist_mux/twist_mux.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

constexpr Duration kCheck = Duration::milliseconds(10);
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TwistMuxOptions three_sources() {
  return {
      .sources = {{.topic = "hand", .priority = 100, .timeout = 0.2, .hand = true},
                  {.topic = "behavior", .priority = 50, .timeout = 0.25, .max_age = 0.25, .stamped = true},
                  {.topic = "planner", .priority = 10, .timeout = 0.5}}};
}

struct MuxWorld {
  static constexpr std::size_t kSources = 3;
  /// By README: a word counts unless it is no number, late, or somebody above has spoken within its time-out.
  bool may_speak(std::size_t i, const Twist2& twist, std::optional<Time> stamp) const {
    if (!is_finite(twist)) return false;
    if (i > 0 && is_interrupted) return false;
    if (is_late(i, stamp)) return false;
    for (std::size_t above = 0; above < i; ++above) {
      const auto& source = options.sources[above];
      if (said[above] && now - *said[above] <= Duration::seconds(source.timeout)) return false;
    }
    return true;
  }

  bool is_late(std::size_t i, std::optional<Time> stamp) const {
    return stamp && now - *stamp > Duration::seconds(options.sources[i].max_age);
  }

  void say(std::size_t i, const Twist2& twist, std::optional<Time> stamp = std::nullopt) {
    const bool may = may_speak(i, twist, stamp);
    const auto speaks = [&](std::size_t k) {
      return said[k] && now - *said[k] <= Duration::seconds(options.sources[k].timeout);
    };
    if (i == 0 && may && (has_goal || speaks(1) || speaks(2))) is_interrupted = true;
    if (i > 0 && is_finite(twist) && !is_late(i, stamp) && twist != Twist2{} && speaks(0))
      is_interrupted = true;
    const auto out = mux.command(now, i, twist, stamp);
    if (may && out != twist) violation = "a word that counts does not go on as it is";
    if (!may && out && *out != Twist2{}) violation = "a word that does not count goes on";
    if (!is_finite(twist) && driver == i && given != Twist2{} && !out)
      violation = "NaN of who drives is no stop";
    if (may) {
      said[i] = now;
      driver = i;
      silent = {};
    }
    give(out);
  }

  void pass(Duration span) {
    for (Duration t; t < span; t = t + kCheck) {
      now = now + kCheck;
      silent = silent + kCheck;
      check();
    }
  }
  void step_back(Duration by) {
    now = now - by;
    for (auto& time : said)
      if (time && *time > now) time.reset();  // what was heard after now is forgotten
    back = back + by;
    check();
  }
  void check() {
    if (mux.is_interrupted() != is_interrupted) violation = "interrupted, or not";
    give(mux.check(now));
    if (given == Twist2{}) return;
    // The clock cannot say how long ago it was when it went back by less than that.
    if (silent > Duration::seconds(options.sources[*driver].timeout) + back)
      violation = "the robot moves after its source has been silent for its time-out";
    if (!mux.active(now)) violation = "the robot moves and nobody drives";
    if (mux.active(now) && mux.active(now) != driver) violation = "somebody else is said to drive";
  }
  void give(const std::optional<Twist2>& out) {
    if (!out) return;
    if (!is_finite(*out)) violation = "what is no number goes on";
    given = *out;
    if (given == Twist2{}) back = {};
  }

  TwistMuxOptions options = three_sources();
  TwistMux mux{options};
  Time now = Time::seconds(100.0);
  std::array<std::optional<Time>, kSources> said;
  std::optional<std::size_t> driver;
  Duration silent;  ///< true time since the last word that counted
  Duration back;    ///< that the clock went back since the robot stood
  Twist2 given;
  bool has_goal = false, is_interrupted = false;
  std::string violation;
};

std::string ages(const MuxWorld& world) {
  std::string text;
  const auto add = [&](Duration age) {
    text += std::to_string(std::min(age, Duration::milliseconds(700)).nanoseconds / 1'000'000) + ' ';
  };
  for (const auto& time : world.said) time ? add(world.now - *time) : void(text += "- ");
  add(world.silent);
  add(world.back);
  return text + (world.driver ? std::to_string(*world.driver) : "-") +
         (world.given == Twist2{} ? " stands" : " moves") + (world.has_goal ? "g" : "-") +
         (world.is_interrupted ? "i" : "-");
}

TEST(TwistMux, PassesOneAndStopsWhoFallsSilentInEverySequence) {
  const Twist2 drives{0.5, 0.1}, stands{}, nan{kNan, 0.0};
  const auto after = [](int ms) { return [ms](MuxWorld& w) { w.pass(Duration::milliseconds(ms)); }; };
  const auto back = [](int ms) { return [ms](MuxWorld& w) { w.step_back(Duration::milliseconds(ms)); }; };
  const auto says = [](std::size_t i, const Twist2& twist) { return [=](MuxWorld& w) { w.say(i, twist); }; };
  const auto stamps = [](const Twist2& twist, int age_ms) {
    return [=](MuxWorld& w) { w.say(1, twist, w.now - Duration::milliseconds(age_ms)); };
  };
  const test::Sequences<MuxWorld> sequences{.make = [] { return MuxWorld{}; },
                                            .events = {{"hand drives", says(0, drives)},
                                                       {"hand stops", says(0, stands)},
                                                       {"hand sends NaN", says(0, nan)},
                                                       {"behavior drives", stamps(drives, 0)},
                                                       {"behavior drives, 300 ms ago", stamps(drives, 300)},
                                                       {"behavior stops", stamps(stands, 0)},
                                                       {"planner drives", says(2, drives)},
                                                       {"planner stops", says(2, stands)},
                                                       {"planner sends NaN", says(2, nan)},
                                                       {"a goal",
                                                        [](MuxWorld& w) {
                                                          w.has_goal = true;
                                                          w.mux.set_goal(true);
                                                        }},
                                                       {"no goal",
                                                        [](MuxWorld& w) {
                                                          w.has_goal = false;
                                                          w.mux.set_goal(false);
                                                        }},
                                                       {"release",
                                                        [](MuxWorld& w) {
                                                          w.is_interrupted = false;
                                                          w.mux.release();
                                                        }},
                                                       {"10 ms", after(10)},
                                                       {"200 ms", after(200)},
                                                       {"600 ms", after(600)},
                                                       {"clock back 100 ms", back(100)},
                                                       {"clock back 5 s", back(5000)}},
                                            .broken = [](const MuxWorld& world) { return world.violation; },
                                            .state = ages};
  test::expect_unbroken("twist_mux", sequences, test::sequence_depth(8));
}

}  // namespace
}  // namespace bw
