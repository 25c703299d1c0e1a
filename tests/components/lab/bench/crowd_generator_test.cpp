#include "components/lab/bench/crowd_generator.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "components/lab/bench/scene_writer.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

constexpr double kRounding = 0.008;  // two decimals per axis

// The rule of the header; the files are written with two decimals.
void expect_rule(const Scene& scene) {
  SCOPED_TRACE(scene.name);
  EXPECT_EQ(scene.start, Pose2());
  EXPECT_EQ(scene.goal, (Pose2{12.0, 0.0, 0.0}));
  std::vector<SceneObstacle> discs;
  std::size_t walkers = 0;
  for (const SceneObstacle& o : scene.obstacles) {
    const Vector2& p = o.position;
    EXPECT_GE(p.norm() - o.radius, 1.5);
    if (o.moves()) {
      ++walkers;
      EXPECT_EQ(o.radius, 0.3);
      EXPECT_TRUE(p.x() >= -0.5 && p.x() <= 12.5 && std::abs(p.y()) <= 3.8) << p.transpose();
      EXPECT_GE(o.velocity.norm(), 0.3 - kRounding);
      EXPECT_LE(o.velocity.norm(), 1.2 + kRounding);
      continue;
    }
    EXPECT_TRUE(o.radius == 0.2 || o.radius == 0.3) << o.radius;
    EXPECT_TRUE(p.x() >= 2.0 && p.x() <= 10.4 && std::abs(p.y()) <= 3.5) << p.transpose();
    for (const SceneObstacle& other : discs)
      EXPECT_GE((p - other.position).norm() - o.radius - other.radius, 1.6);
    discs.push_back(o);
  }
  EXPECT_EQ(discs.size(), 6u);
  EXPECT_TRUE(walkers == 6 || walkers == 10 || walkers == 14) << walkers;
}

TEST(CrowdGenerator, ThreeHundredScenesKeepTheRuleInEqualShares) {
  std::map<std::size_t, int> scenes_of;
  for (const Scene& scene : generate_crowd(300, 1)) {
    expect_rule(scene);
    ++scenes_of[scene.obstacles.size()];
  }
  EXPECT_EQ(scenes_of, (std::map<std::size_t, int>{{12, 100}, {16, 100}, {20, 100}}));
}

TEST(CrowdGenerator, SpeedsAndHeadingsAreUniform) {
  // 3000 walkers. Mean speed 0.75 +- 0.9 / sqrt(12 * 3000) = 0.0047 (four of these allowed); 375 +- 18.1 in
  // every eighth of the circle.
  double speed = 0.0;
  int walkers = 0;
  std::map<int, int> eighths;
  for (const Scene& scene : generate_crowd(300, 1000)) {
    for (const SceneObstacle& o : scene.obstacles) {
      if (!o.moves()) continue;
      ++walkers;
      speed += o.velocity.norm();
      const double revolutions = std::atan2(o.velocity.y(), o.velocity.x()) / (2.0 * std::numbers::pi);
      ++eighths[static_cast<int>(std::floor(8.0 * revolutions))];
    }
  }
  EXPECT_EQ(walkers, 3000);
  EXPECT_NEAR(speed / walkers, 0.75, 0.019);
  for (int eighth = -4; eighth < 4; ++eighth) EXPECT_NEAR(eighths[eighth], 375, 73) << eighth;
}

TEST(CrowdGenerator, ASceneDependsOnItsSeedOnly) {
  const auto text = [](std::vector<Scene> scenes) {
    SceneFile file = crowd_rules();
    file.scenes = std::move(scenes);
    return to_yaml(file);
  };
  const std::vector<Scene> five = generate_crowd(5, 20);
  EXPECT_EQ(text({five[3], five[4]}), text(generate_crowd(2, 23)));
  EXPECT_NE(text({five[0]}), text({five[3]}));
  EXPECT_TRUE(generate_crowd(0, 1).empty());
  EXPECT_THROW(generate_crowd(-1, 1), std::runtime_error);
}

// 14 x 8 m: 0.3 per square metre are 33.6, 0.5 are 56 persons. The discs are those of the same seed.
TEST(CrowdGenerator, DenseCrowdsHaveTheirDensityAndKeepApart) {
  for (const auto& [density, walkers] : {std::pair{0.3, 34U}, std::pair{0.5, 56U}}) {
    for (const Scene& scene : generate_dense_crowd(20, 5001, density)) {
      SCOPED_TRACE(scene.name);
      ASSERT_EQ(scene.obstacles.size(), 6U + walkers);
      for (std::size_t i = 6; i < scene.obstacles.size(); ++i) {
        const SceneObstacle& a = scene.obstacles[i];
        EXPECT_TRUE(a.moves());
        EXPECT_EQ(a.radius, 0.3);
        EXPECT_GE(a.position.norm() - a.radius, 1.5);
        EXPECT_NEAR(a.velocity.norm(), 0.75, 0.45 + kRounding);
        for (std::size_t k = 0; k < i; ++k) {
          const SceneObstacle& b = scene.obstacles[k];
          EXPECT_GE((a.position - b.position).norm() - a.radius - b.radius, 0.1 - 1e-9);
        }
      }
    }
  }
  const Scene sparse = generate_crowd_scene(5003);
  const Scene dense = generate_dense_crowd_scene(5003, 0.3);
  EXPECT_EQ(dense.name, "seed5003_34");
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(dense.obstacles[i].position, sparse.obstacles[i].position);
  EXPECT_THROW(generate_dense_crowd_scene(1, 0.0), std::runtime_error);
  EXPECT_THROW(generate_dense_crowd_scene(1, 1.5), std::runtime_error);
}

TEST(SceneWriter, GeneratedScenesReadBackEqual) {
  SceneFile file = crowd_rules();
  file.scenes = generate_crowd(4, 7);
  const std::string path = ::testing::TempDir() + "crowd_generator_test.yaml";
  write_file_atomically(path, to_yaml(file));
  const SceneFile back = read_scene_file(path);
  EXPECT_EQ(to_yaml(back), to_yaml(file));
  ASSERT_EQ(back.scenes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_EQ(back.scenes[i].obstacles.size(), file.scenes[i].obstacles.size());
    for (std::size_t k = 0; k < file.scenes[i].obstacles.size(); ++k) {
      EXPECT_EQ(back.scenes[i].obstacles[k].position, file.scenes[i].obstacles[k].position);
      EXPECT_EQ(back.scenes[i].obstacles[k].velocity, file.scenes[i].obstacles[k].velocity);
    }
  }
}

TEST(SceneWriter, AnEmptySceneReadsBack) {
  SceneFile file = crowd_rules();
  file.closed_loop.reset();
  file.scenes = {Scene{"nobody", {}, {3.0, 0.0, 0.0}, {}}};
  const std::string path = ::testing::TempDir() + "scene_writer_test.yaml";
  write_file_atomically(path, to_yaml(file));
  const SceneFile back = read_scene_file(path);
  EXPECT_FALSE(back.closed_loop.has_value());
  EXPECT_TRUE(back.scenes.at(0).obstacles.empty());
}

TEST(SharedCrowdScenes, KeepTheRuleAndTheHeadOfTheGenerator) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED names no folder with scenes/";
  SceneFile file = read_scene_file(std::string(shared) + "/scenes/teb_crowd_scenes.yaml");
  ASSERT_EQ(file.scenes.size(), 30u);
  for (const Scene& scene : file.scenes) expect_rule(scene);
  file.scenes.clear();
  EXPECT_EQ(to_yaml(file), to_yaml(crowd_rules()));
}

}  // namespace
}  // namespace bw
