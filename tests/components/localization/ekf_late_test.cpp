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
  for (std::size_t i = 0; i < kMaxSources; ++i) {
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

// Anchors 1.3: fixes 0.5 s late, rewound: as accurate as in time (0.04 m there), where use on arrival triples
// the error. Receiver 0.5 m at 5 Hz, 0.8 m/s.
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
  fix.time = now + Duration::milliseconds(101);  // future_tolerance is 0.1 s
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
  EventRing ring(fusion, Duration::seconds(2.0), small.capacity);
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
