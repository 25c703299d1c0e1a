// Where somebody hidden may be: before walls that were seen, not where the laser sees that nobody is.
#include <gtest/gtest.h>

#include "components/people/tracker/occlusion_memory.hpp"
#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

/// Beams that would end farther than the line x = `wall`, from y = -3 m to 3 m, end there.
void see_wall(Stage& stage, double wall) {
  DetectionSet& set = stage.set();
  for (std::size_t i = 0; i < set.free_ranges.size(); ++i) {
    const Vector2 along = direction(set.angle_min + static_cast<double>(i) * set.angle_increment);
    if (along.x() <= 0.0 || std::abs(along.y() / along.x() * wall) > 3.0) continue;
    set.free_ranges[i] = std::min(set.free_ranges[i], static_cast<float>(wall / along.x()));
  }
}

/// A wall at x = 4 m, after it was seen for `seconds`, ten sweeps a second.
SeenWalls walls_after(Stage& stage, double seconds) {
  SeenWalls walls;
  for (int k = 0; 0.1 * k < seconds + 0.05; ++k) {
    stage.begin(0.1 * k);
    see_wall(stage, 4.0);
    walls.add(stage.set(), 0.1 * k, {});
  }
  return walls;
}

// A wall is what beams end at for 1 s, and is forgotten after 30 s.
TEST(SeenWalls, AreWhatStoodForASecond) {
  Stage stage;
  EXPECT_FALSE(walls_after(stage, 0.9).contains({4.03, 0.0}));
  SeenWalls walls = walls_after(stage, 1.1);
  EXPECT_TRUE(walls.contains({4.03, 0.0}));
  EXPECT_FALSE(walls.contains({3.85, 0.0}));
  EXPECT_FALSE(walls.contains({4.25, 0.0}));
  const auto later = [&](double t) {
    stage.begin(t);  // nothing in reach: nothing is seen to stand
    walls.add(stage.set(), t, {});
    return walls.contains({4.03, 0.0});
  };
  EXPECT_TRUE(later(30.9));
  EXPECT_FALSE(later(31.3));
}

TEST(SeenWalls, PeopleAreNone) {
  Stage stage;
  SeenWalls walls;
  const Vector2 person(3.9, 0.0);
  for (int k = 0; k <= 20; ++k) {
    stage.begin(0.1 * k);
    see_wall(stage, 4.0);
    walls.add(stage.set(), 0.1 * k, {&person, 1});
  }
  EXPECT_FALSE(walls.contains({4.03, 0.0}));  // 0.14 m from them, within 0.5 m
  EXPECT_TRUE(walls.contains({4.03, 1.0}));
}

struct Mass {
  double free = 0.0;
  double beyond = 0.0;
};

/// How much of the density lies before and beyond the wall at x = 4 m, on a raster of 0.1 m.
Mass mass_of(const OcclusionMemory& where, const HiddenOptions& options) {
  Mass mass;
  for (double x = 0.0; x < 8.0; x += 0.1)
    for (double y = -6.0; y < 6.0; y += 0.1)
      (x < 4.0 ? mass.free : mass.beyond) += 0.01 * where.density({x, y}, std::nullopt, 0.0, options);
  return mass;
}

// Towards the wall at 1 m/s for 2 s, 1 m before it at first: straight on all would be beyond. The kernel,
// here 0.1 m, smears none across, as nobody's middle comes nearer than 0.2 m.
TEST(OcclusionMemory, NotBeyondAWall) {
  Stage stage;
  const SeenWalls walls = walls_after(stage, 1.1);
  stage.hide({4.0, 0.0}, 8.0, 0.5);  // all of the room is hidden now
  HiddenOptions options;
  options.position_kernel = 0.1;
  Random random(3);
  OcclusionMemory where({3.0, 0.0}, {1.0, 0.0}, random, options);
  const auto before = where.moments();
  for (int k = 0; k < 20; ++k) where.pass(0.1, 0.1, stage.set(), walls, random, options);
  const double density_at_no_speed = std::pow(2.0 * std::numbers::pi * 0.25, -1.0);  // velocity unknown
  const Mass mass = mass_of(where, options);
  EXPECT_GE(mass.free, 0.9 * density_at_no_speed);
  EXPECT_LE(mass.beyond, 0.05 * mass.free);
  EXPECT_GE(where.moments().covariance(1, 1), 4.0 * before.covariance(1, 1));  // spread along it
  EXPECT_NEAR(where.existence(), 1.0, 1e-9);
}

// Seen empty all over for 1 s: exp(-1 / 0.33) = 0.048 is left. Hidden: all.
TEST(OcclusionMemory, FadesWhereNobodyIsSeen) {
  Stage stage;
  stage.begin(0.0);
  const SeenWalls walls;
  Random random(3);
  OcclusionMemory seen({3.0, 0.0}, {0.0, 0.0}, random, {});
  for (int k = 0; k < 10; ++k) seen.pass(0.1, 0.1, stage.set(), walls, random, {});
  EXPECT_NEAR(seen.existence(), 0.048, 0.001);
  stage.hide({3.0, 0.0}, 2.0, 1.0);
  OcclusionMemory hidden({3.0, 0.0}, {0.0, 0.0}, random, {});
  for (int k = 0; k < 10; ++k) hidden.pass(0.1, 0.1, stage.set(), walls, random, {});
  EXPECT_NEAR(hidden.existence(), 1.0, 1e-9);
}

// A pillar hides y = -1 m to 1 m at x = 3 m. Who went behind it at 0.5 m/s has not come out after 4 s, when
// half of the guesses would have: the rest are behind it.
TEST(OcclusionMemory, GathersInWhatIsHidden) {
  Stage stage;
  stage.begin(0.0);
  stage.hide({3.0, 0.0}, 1.0, 1.5);
  const SeenWalls walls;
  Random random(3);
  OcclusionMemory where({3.0, -0.9}, {0.0, 0.5}, random, {});
  for (int k = 0; k < 40; ++k) where.pass(0.1, 0.1, stage.set(), walls, random, {});
  EXPECT_LT(std::abs(where.moments().mean(1)), 1.0);
  EXPECT_GT(where.existence(), 0.2);
  EXPECT_LT(where.existence(), 0.95);
  const auto density = [&](double y) { return where.density({3.0, y}, std::nullopt, 0.0, {}); };
  EXPECT_GT(density(0.5), 5.0 * density(2.0));
}

TEST(OcclusionMemory, TheSameSeedGuessesTheSame) {
  const auto mean = [] {
    Stage stage;
    stage.begin(0.0);
    Random random(9);
    OcclusionMemory where({1.0, 2.0}, {0.3, 0.4}, random, {});
    for (int k = 0; k < 10; ++k) where.pass(0.1, 0.1, stage.set(), SeenWalls(), random, {});
    return where.moments().mean;
  };
  EXPECT_EQ(mean(), mean());
}

// Towards a wall at 1 m/s, hidden by somebody 1 m before it, for 1.5 s: a tracker that lets people go
// straight on has them 0.5 m behind the wall.
TEST(Tracker, WhoIsHiddenStaysBeforeTheWall) {
  Stage stage;
  Tracker tracker({});
  for (int k = 0; k < 42; ++k) {
    const double t = 0.1 * k;
    stage.begin(t);
    see_wall(stage, 4.0);
    const double x = 1.5 + std::max(0.0, t - 1.2);
    const double swing = t > 1.2 ? 0.14 * std::sin(2.0 * std::numbers::pi * x / 1.4) : 0.0;
    if (k >= 27) {
      stage.hide({3.0, 0.5}, 1.0, 1.2);
    } else {
      stage.add({x + swing, 0.62}, 0.9);
      stage.add({x - swing, 0.38}, 0.9);
    }
    tracker.update(stage.set());
    if (k < 27) continue;
    ASSERT_EQ(tracker.people().size(), 1U) << t;
    EXPECT_LT(tracker.people()[0].position.x(), 4.0) << t;
  }
  const TrackedPerson& person = tracker.people()[0];
  EXPECT_GT(person.covariance(1, 1), person.covariance(0, 0));  // along the wall
}

}  // namespace
}  // namespace bw::people
