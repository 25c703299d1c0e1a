// Late and out-of-order measurements: the order of arrival within the window changes nothing, to the last
// bit.
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

struct Arrival {
  Time at;
  Measurement measurement;
};

std::vector<Arrival> arrivals(const Drive& drive, Random& random, double latest) {
  std::vector<Arrival> result;
  for (const Measurement& m : drive.measurements)
    result.push_back({stamp(m) + Duration::seconds(random.uniform(0.0, latest)), m});
  std::stable_sort(result.begin(), result.end(),
                   [](const Arrival& a, const Arrival& b) { return a.at < b.at; });
  return result;
}

void expect_same_bits(const EkfState& a, const EkfState& b) {
  EXPECT_EQ(std::memcmp(a.x.data(), b.x.data(), sizeof(double) * kStates), 0);
  EXPECT_EQ(std::memcmp(a.P.data(), b.P.data(), sizeof(double) * kStates * kStates), 0);
  EXPECT_EQ(a.time, b.time);
  for (std::size_t i = 0; i < a.sources.size(); ++i) {
    EXPECT_EQ(a.sources[i].used, b.sources[i].used);
    EXPECT_EQ(a.sources[i].rejected, b.sources[i].rejected);
    EXPECT_EQ(a.sources[i].nis_all, b.sources[i].nis_all);
  }
}

void start(Ekf& ekf) { ASSERT_TRUE(ekf.start_at({}, 0.01 * Eigen::Matrix3d::Identity(), kStart)); }

TEST(EkfLate, AnyOrderWithinTheWindowGivesTheSameBits) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.seconds = 6.0;
    options.gyro_bias = 0.02;
    options.slip_from = 3.0;  // gates and slip are met too
    Drive drive = simulate(options);
    Random random(seed);
    for (Measurement& m : drive.measurements)
      if (auto* fix = std::get_if<PositionFix>(&m); fix != nullptr && random.uniform() < 0.1)
        fix->position.x() += 42.0;
    EkfOptions ekf_options;
    Ekf ordered(ekf_options), shuffled(ekf_options);
    start(ordered);
    start(shuffled);
    for (const Measurement& m : drive.measurements) ordered.add(m, stamp(m));
    // Up to 1.99 s late: of any two, the one stamped earlier comes at most 1.99 s after the other's stamp.
    int late = 0;
    for (const Arrival& a : arrivals(drive, random, seed % 3 == 0 ? 1.99 : 0.3))
      late += shuffled.add(a.measurement, a.at).replayed > 0 ? 1 : 0;
    EXPECT_GT(late, 500);
    expect_same_bits(ordered.state(), shuffled.state());
    EXPECT_EQ(shuffled.count(Verdict::too_old), 0U);
  }
}

// localization/evidence.md 9.1: fixes 0.5 s late, rewound: as accurate as in time (0.04 m there), where use
// on arrival triples the error. Receiver 0.5 m at 5 Hz, 0.8 m/s.
TEST(EkfLate, FixesHalfASecondLateCostNothing) {
  double in_time = 0.0, rewound = 0.0, on_arrival = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.seconds = 120.0;
    const Drive drive = simulate(options);
    for (double* sum : {&in_time, &rewound, &on_arrival}) {
      std::vector<Arrival> list;
      for (Measurement m : drive.measurements) {
        Time at = stamp(m);
        if (auto* fix = std::get_if<PositionFix>(&m); fix != nullptr && sum != &in_time) {
          at = at + Duration::milliseconds(500);
          if (sum == &on_arrival) fix->time = at;
        }
        list.push_back({at, m});
      }
      std::stable_sort(list.begin(), list.end(),
                       [](const Arrival& a, const Arrival& b) { return a.at < b.at; });
      Ekf ekf({});
      start(ekf);
      int step = 0;
      for (const Arrival& a : list) {
        ekf.add(a.measurement, a.at);
        if (!std::holds_alternative<WheelStep>(a.measurement)) continue;
        ++step;
        *sum += (ekf.estimate().X_MB.position() - drive.truth[static_cast<std::size_t>(step)].position())
                    .squaredNorm() /
                (5.0 * 12000.0);
      }
    }
  }
  RecordProperty("in_time", std::to_string(std::sqrt(in_time)));
  RecordProperty("rewound", std::to_string(std::sqrt(rewound)));
  RecordProperty("on_arrival", std::to_string(std::sqrt(on_arrival)));
  EXPECT_LE(std::sqrt(rewound), 1.1 * std::sqrt(in_time));
  EXPECT_GE(std::sqrt(on_arrival), 2.0 * std::sqrt(rewound));
}

// The conditions of localization/evidence.md 9.1 themselves: 600 s, encoders 100 Hz with 0.03 m/s and 0.02
// rad/s, headings 100 Hz with 0.05 rad, fixes 5 Hz with 0.5 m, no gyro. Measured there: 0.038 m in order and
// rewound, 0.146 m used on arrival; asked of this filter: 0.04 m where the other gives 0.15 m.
TEST(EkfLate, MeetsTheFiguresOfTheField) {
  constexpr int kSteps = 60000;
  const Eigen::Matrix2d wheel_noise = Eigen::Vector2d(0.03 * 0.01, 0.02 * 0.01).cwiseAbs2().asDiagonal();
  Random random(1);
  std::vector<Pose2> truth{Pose2{}};
  std::vector<Measurement> measured;
  for (int i = 1; i <= kSteps; ++i) {
    const Twist2 twist{0.8, 0.5 * std::sin(2.0 * std::numbers::pi * (i - 0.5) * 0.01 / 20.0)};
    const Pose2 X = advance_exact(truth.back(), twist, 0.01);
    truth.push_back(X);
    const Time now = step_time(i);
    WheelStep step{now,
                   kWheels,
                   kStep,
                   0.01 * (twist.v + 0.03 * random.normal()),
                   0.01 * (twist.omega + 0.02 * random.normal()),
                   wheel_noise};
    measured.push_back(step);
    measured.push_back(HeadingReading{now, kCompass, wrap_angle(X.theta + 0.05 * random.normal()), 0.0025});
    if (i % 20 != 0) continue;
    const Vector2 position = X.position() + 0.5 * Vector2(random.normal(), random.normal());
    measured.push_back(PositionFix{now, kGps, position, 0.25 * Eigen::Matrix2d::Identity(), {0.0, 0.0}});
  }
  const auto rms = [&](int late_ms, bool restamped) {
    std::vector<Arrival> list;
    for (Measurement m : measured) {
      Time at = stamp(m);
      if (auto* fix = std::get_if<PositionFix>(&m)) {
        at = at + Duration::milliseconds(late_ms);
        if (restamped) fix->time = at;
      }
      list.push_back({at, m});
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Arrival& a, const Arrival& b) { return a.at < b.at; });
    Ekf ekf({});
    start(ekf);
    double squares = 0.0;
    std::size_t step = 0;
    for (const Arrival& a : list) {
      ekf.add(a.measurement, a.at);
      if (std::holds_alternative<WheelStep>(a.measurement))
        squares += (ekf.estimate().X_MB.position() - truth[++step].position()).squaredNorm();
    }
    return std::sqrt(squares / kSteps);
  };
  const double rewound = rms(500, false);
  const double on_arrival = rms(500, true);
  RecordProperty("rewound", std::to_string(rewound));
  RecordProperty("on_arrival", std::to_string(on_arrival));
  EXPECT_LE(rewound, 0.045);
  EXPECT_GE(on_arrival, 0.13);  // 0.19 here: by how much the path curves
}

TEST(EkfLate, OlderThanTheWindowAndTwiceAreCounted) {
  DriveOptions options;
  options.seconds = 5.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  start(ekf);
  for (const Measurement& m : drive.measurements) ekf.add(m, stamp(m));
  const EkfState before = ekf.state();
  const Time now = step_time(500);
  PositionFix fix;
  fix.source = kGps;
  fix.time = now - Duration::milliseconds(2001);
  EXPECT_EQ(ekf.add(fix, now).verdict, Verdict::too_old);
  EXPECT_EQ(ekf.add(drive.measurements.back(), now).verdict, Verdict::duplicate);
  fix.time = now + Duration::milliseconds(101);  // kFutureTolerance is 0.1 s
  EXPECT_EQ(ekf.add(fix, now).verdict, Verdict::future);
  expect_same_bits(before, ekf.state());
  EXPECT_EQ(ekf.count(Verdict::too_old), 1U);
  EXPECT_EQ(ekf.count(Verdict::duplicate), 1U);
  EXPECT_EQ(ekf.count(Verdict::future), 1U);
}

TEST(EkfLate, ASmallRingShortensTheWindowAndSaysSo) {
  DriveOptions options;
  options.seconds = 5.0;
  const Drive drive = simulate(options);
  EkfOptions small;
  small.capacity = 16;
  const Fusion fusion(small);
  EventRing ring(fusion, Duration::seconds(2.0), small.capacity, kUsualSources);
  EkfState state;
  state.time = state.last_wheel = kStart;
  state.P.topLeftCorner<3, 3>().setIdentity();
  ring.restart(state);
  for (const Measurement& m : drive.measurements) EXPECT_NE(ring.insert(m).result.verdict, Verdict::too_old);
  EXPECT_EQ(ring.size(), 16);
  EXPECT_EQ(ring.squeezed_out(), drive.measurements.size() - 16);
  EXPECT_EQ(ring.insert(drive.measurements[0]).result.verdict, Verdict::too_old);
}

}  // namespace
}  // namespace bw::localization
