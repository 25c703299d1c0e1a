#include "components/lab/battery/injection_judge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace bw {
namespace {

constexpr double kStands = 0.01;  // [m/s]
constexpr double kSlower = 0.02;  // [m/s] noise is below
constexpr double kDrives = 0.1;   // [m/s]

double speed_at(const std::vector<InjectedDrive::Speed>& speeds, double t) {
  const auto after = std::ranges::upper_bound(speeds, t, {}, &InjectedDrive::Speed::t);
  return after == speeds.begin() ? 0.0 : std::prev(after)->v;
}

class Judge {
 public:
  Judge(const InjectedDrive& drive, const InjectedProcesses& processes, const InjectionRules& rules)
      : drive_(drive), processes_(processes), rules_(rules) {
    for (const auto& told : drive.told) told_.push_back(told.t);
  }

  [[nodiscard]] JudgedInjection judge(const InjectedDrive::Begun& begun, double end) const {
    JudgedInjection judged{
        .injection = begun.injection, .speed = speed_at(drive_.truth, begun.t), .trouble = {}};
    judged.standing = first(drive_.truth, begun.t, end, [](double v) { return std::abs(v) < kStands; });
    const double base = judged.standing ? begun.t + *judged.standing : begun.t;
    if (const auto again = first(drive_.truth, base, end, [](double v) { return v > kDrives; }))
      judged.again = base - begun.t + *again;
    if (begun.injection.process == processes_.commander) {
      judge_stop(drive_.commands, rules_.command_age, begun.t, end, judged);
    } else if (begun.injection.process == processes_.base) {
      judge_stop(told_, rules_.command_age, begun.t, end,
                 judged);  // by what is beyond it: firmware, here the world
    } else {
      judge_stop(drive_.poses, rules_.pose_age, begun.t, end, judged);
    }
    return judged;
  }

 private:
  /// Until nobody goes by it any more the robot may gain speed.
  [[nodiscard]] double fastest(double from, double end) const {
    double speed = speed_at(drive_.truth, from);
    for (const auto& [t, v] : drive_.truth) {
      if (t >= from && t < end) speed = std::max(speed, v);
    }
    return speed;
  }
  template <class Holds>
  static std::optional<double> first(const std::vector<InjectedDrive::Speed>& speeds, double from, double end,
                                     Holds holds) {
    for (const auto& [t, v] : speeds) {
      if (t >= from && t < end && holds(v)) return t - from;
    }
    return std::nullopt;
  }
  /// The longest time without a word from there on, which begins with the last one before it.
  static std::pair<double, double> longest_silence(const std::vector<double>& said, double from, double end) {
    double last = from;
    std::pair<double, double> longest{from, 0.0};
    for (const double t : said) {
      if (t < from) {
        last = t;
        continue;
      }
      if (t > end) break;
      if (t - last > longest.second) longest = {last, t - last};
      last = t;
    }
    if (end - last > longest.second) longest = {last, end - last};
    return longest;
  }
  /// Where what it says was gone for longer than it may be old, while the robot drove.
  void judge_stop(const std::vector<double>& said, double age, double from, double end,
                  JudgedInjection& judged) const {
    const auto [last, silence] = longest_silence(said, from, end);
    const double speed = fastest(last, last + age);
    if (silence < age || speed < kDrives) return;
    // Who plans on goes slower for reasons of his own: only where nobody commands the first slower frame tells something.
    if (&said == &drive_.commands) {
      judged.stop_frame = stop_frame(last, end);
      const double frame = judged.stop_frame.value_or(silence);
      if (frame > age)
        judged.trouble = fmt::format("stop frame {:.0f} ms after the last command", 1e3 * frame);
    }
    const double takes = age + speed / rules_.deceleration + rules_.margin;
    judged.allowed = last - from + takes;
    if (silence > takes && judged.standing.value_or(1e9) > *judged.allowed)
      judged.trouble =
          judged.standing ? fmt::format("stood after {:.2f} s of {:.2f} s", *judged.standing, *judged.allowed)
                          : "did not stand";
  }
  /// From the last command on, to the first slower one to the wheels behind what was on its way; nothing: there was none.
  [[nodiscard]] std::optional<double> stop_frame(double last, double end) const {
    constexpr double kOnItsWay = 0.05;  // [s]
    const double before = speed_at(drive_.told, last);
    const auto slower =
        first(drive_.told, last + kOnItsWay, end, [&](double v) { return v < before - kSlower; });
    return slower ? std::optional(kOnItsWay + *slower) : std::nullopt;
  }

  const InjectedDrive& drive_;
  const InjectedProcesses& processes_;
  const InjectionRules& rules_;
  std::vector<double> told_;  ///< when the wheels were told anything
};

}  // namespace

std::vector<JudgedInjection> judge(const InjectedDrive& drive, const InjectedProcesses& processes,
                                   const InjectionRules& rules) {
  const Judge one(drive, processes, rules);
  std::vector<JudgedInjection> judged;
  const double last = drive.truth.empty() ? 0.0 : drive.truth.back().t;
  for (std::size_t i = 0; i < drive.begun.size(); ++i) {
    const double end = i + 1 < drive.begun.size() ? drive.begun[i + 1].t : last;
    judged.push_back(one.judge(drive.begun[i], end));
  }
  return judged;
}

}  // namespace bw
