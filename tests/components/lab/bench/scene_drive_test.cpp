// Scenes in which others move: T-MPC's corridor, DynaBARN's worlds. Expected numbers are worked out by hand beside them.
#include "components/lab/bench/scene_drive.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/lab/bench/corridor/corridor_scene.hpp"
#include "components/lab/bench/dynabarn_world.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "tests/components/lab/bench/constant_planner.hpp"

namespace bw {
namespace {

using test::ConstantPlanner;

double no_time() { return 0.0; }

const SceneRobot kFarRobot{{-100.0, 0.0}, {0.0, 0.0}};

// Alone in the middle, at 1 m/s along x: drawn by its top speed, and off both walls alike, of which one counts:
// 3 exp(-(3.5 - 0.5) / 0.8) = 0.0706 m/s^2 from the first of two that are as near.
TEST(PedsimForce, DrawsToTheGoalAndOffTheNearestWall) {
  std::vector<PedsimPerson> people{
      {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}, .goal = {20.0, 0.0}, .speed = 1.2}};
  const std::vector<Segment> walls{{{-50.0, -3.5}, {50.0, -3.5}}, {{-50.0, 3.5}, {50.0, 3.5}}};
  const Vector2 force = pedsim_force(people, 0, kFarRobot, walls);
  EXPECT_NEAR(force.x(), 1.2, 1e-12);
  EXPECT_NEAR(force.y(), 3.0 * std::exp(-3.0 / 0.8), 1e-12);
  // 0.05 s of it, held to 1.2 m/s.
  pedsim_step(people, kFarRobot, {});
  EXPECT_NEAR(people[0].velocity.x(), 1.06, 1e-12);
  EXPECT_NEAR(people[0].position.x(), 0.053, 1e-12);
  for (int k = 0; k < 100; ++k) pedsim_step(people, kFarRobot, {});
  EXPECT_NEAR(people[0].velocity.norm(), 1.2, 1e-12);
}

// Somebody straight ahead at 1 m who stands: D = 2 (1, 0) + (1, 0), B = 1.05, no angle: 2.1 exp(-1 / 1.05) back. It stands,
// so that no side is taken. At 2.5 m nothing.
TEST(PedsimForce, PushesBackFromWhoIsAhead) {
  std::vector<PedsimPerson> people(2);
  people[0] = {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}, .goal = {20.0, 0.0}};
  people[1].position = {1.0, 0.0};
  const Vector2 near = pedsim_force(people, 0, kFarRobot, {});
  EXPECT_NEAR(near.x(), 1.2 - 2.1 * std::exp(-1.0 / 1.05), 1e-12);
  EXPECT_NEAR(near.y(), 0.0, 1e-12);
  people[1].position = {2.5, 0.0};
  EXPECT_NEAR(pedsim_force(people, 0, kFarRobot, {}).x(), 1.2, 1e-12);
}

// Who comes towards one 5 m ahead on the right is passed on the left, by 0.5 m/s^2; the robot as well.
TEST(PedsimForce, TakesTheOtherSideOfWhoComesTowardsOne) {
  std::vector<PedsimPerson> people(2);
  people[0] = {.position = {0.0, 0.0}, .velocity = {1.0, 0.0}, .goal = {20.0, 0.0}};
  people[1] = {.position = {5.0, -0.5}, .velocity = {-1.0, 0.0}, .goal = {-20.0, -0.5}};
  EXPECT_NEAR(pedsim_force(people, 0, kFarRobot, {}).y(), 0.5, 1e-12);
  people.resize(1);
  EXPECT_NEAR(pedsim_force(people, 0, {{5.0, 0.5}, {-2.0, 0.0}}, {}).y(), -0.5, 1e-12);
}

TEST(CorridorPeople, ComeFromBothEndsAndKeepTheirRules) {
  int from_ahead = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::vector<PedsimPerson> people = corridor_people(12, seed);
    ASSERT_EQ(people.size(), 12U);
    for (const PedsimPerson& p : people) {
      const bool ahead = p.position.x() >= 20.0;
      from_ahead += ahead ? 1 : 0;
      ++all;
      EXPECT_GE(p.position.norm(), 4.0);
      EXPECT_LE(std::abs(p.position.y()), 3.0);
      EXPECT_LE(p.position.x(), ahead ? 35.0 : 12.0);
      EXPECT_GE(p.goal.x(), ahead ? -10.0 : 34.0);
      EXPECT_LE(p.goal.x(), ahead ? 5.0 : 42.0);
    }
    EXPECT_EQ(corridor_people(4, seed)[3].position, people[3].position) << "fewer are the first of more";
  }
  // Half of 2400, within three standard deviations of 24.5.
  EXPECT_NEAR(from_ahead, 0.5 * all, 74.0);
}

// Of 1200 people the mean speed is within three standard deviations.
TEST(StraightCorridor, KeepsItsBoxesAndVelocities) {
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto movers = straight_corridor_scene(12, seed).movers->clone();
    const std::vector<SceneDisc> before = movers->discs();
    for (int k = 0; k < 600; ++k) movers->step({});
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_GE(before[i].position.x(), 4.0);
      EXPECT_LE(before[i].position.x(), 20.0);
      EXPECT_LE(std::abs(before[i].position.y()), 3.0);
      const Vector2 walked = movers->discs()[i].position - before[i].position;
      EXPECT_TRUE(walked.isApprox(30.0 * before[i].velocity, 1e-9)) << "for ever";
      sum += before[i].velocity.norm();
      squares += before[i].velocity.squaredNorm();
    }
  }
  const double mean = sum / 1200.0;
  EXPECT_NEAR(mean, 1.4, 3.0 * 0.26 / std::sqrt(1200.0));
  EXPECT_NEAR(std::sqrt(squares / 1200.0 - mean * mean), 0.26, 0.02);
}

TEST(Crossing, LeadsOverThreeSidewalks) {
  int sidewalks[3] = {0, 0, 0};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const DriveScene scene = crossing_scene(seed);
    ASSERT_EQ(scene.movers->discs().size(), 16U);
    for (const SceneDisc& disc : scene.movers->discs()) {
      const double x = disc.position.x();
      const int sidewalk = x < 12.0 ? 0 : x < 19.0 ? 1 : 2;
      ++sidewalks[sidewalk];
      EXPECT_EQ(disc.velocity.y() > 0.0, sidewalk == 0);
      EXPECT_GE(std::abs(disc.position.y()), 3.0) << "off the road";
    }
  }
  for (const int count : sidewalks) EXPECT_NEAR(count, 1600 / 3.0, 3.0 * std::sqrt(1600.0 * 2.0 / 9.0));
}

// 1 m/s, and 1.3 where a file names no speed.
TEST(Crossing, OfOneTwoAndThree) {
  const std::vector<DriveScene> scenes = fixed_crossings();
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[0].movers->discs()[0].velocity, Vector2(0.0, 1.0));
  EXPECT_EQ(scenes[1].movers->discs()[1].velocity, Vector2(0.0, -1.0));
  ASSERT_EQ(scenes[2].movers->discs().size(), 3U);
  EXPECT_EQ(scenes[2].movers->discs()[2].velocity, Vector2(0.0, -1.3));
}

// The files that the rules were read from: what they say of starts, goals and speeds.
TEST(SharedTmpcScenes, SayWhatTheRulesSay) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED names no folder with data/tmpc_scenarios/";
  const std::filesystem::path folder = std::filesystem::path(shared) / "data" / "tmpc_scenarios";
  const auto text_of = [&](const std::string& name) {
    std::ifstream in(folder / name);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto count = [](const std::string& text, const std::string& what) {
    int found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  using testing::HasSubstr;
  for (const int people : {8, 12, 16}) {
    const std::string text = text_of("random_fast_" + std::to_string(people) + "_straight.xml");
    EXPECT_THAT(text, HasSubstr(R"(range_x min="4" max="20")"));
    EXPECT_THAT(text, HasSubstr(R"(range_y min="-3" max="3")"));
    EXPECT_THAT(text, HasSubstr(R"(range_v min="1.14" max="1.66")")) << "1.4 less and more 0.26";
    EXPECT_EQ(count(text, "<pedestrian>"), people);
  }
  EXPECT_THAT(text_of("random_fast_4_straight.xml"), HasSubstr(R"(range_x min="1" max="10")"));
  const std::string sidewalks = text_of("crossing_16_random.xml");
  EXPECT_EQ(count(sidewalks, "<pedestrian>"), kCrossingPeople);
  EXPECT_EQ(count(sidewalks, R"(range_v min="0.7" max="1.0")"), 3);
  for (const char* box :
       {R"(range_x min="8" max="10")", R"(range_y min="-10" max="-3")", R"(range_x min="14" max="16")",
        R"(range_y min="6" max="14")", R"(range_x min="22" max="24")", R"(range_y min="10" max="15")"})
    EXPECT_THAT(sidewalks, HasSubstr(box));
  const std::string three = text_of("crossing_3_lrl.xml");
  for (const SceneDisc& disc : fixed_crossings()[2].movers->discs()) {
    std::ostringstream start;
    start << "start x=\"" << disc.position.x() << "\" y=\"" << disc.position.y() << "\"";
    EXPECT_THAT(three, HasSubstr(start.str()));
  }
  EXPECT_THAT(text_of("crossing_1_left.xml"), HasSubstr(R"(type="velocity" value="1.0")"));
  EXPECT_EQ(count(three, "velocity"), 0);
}

// From rest by 2 m/s^2 to 2 m/s: 25 m in 25 / 2 + 0.5 s and the step that ends beyond it.
TEST(SceneDrive, OfAnEmptyCorridorTakesThirteenSeconds) {
  ConstantPlanner planner({2.0, 0.0});
  const SceneDrive drive =
      drive_scene(corridor_scene(0, 1), ScenePrediction::constant_velocity, planner, no_time);
  EXPECT_TRUE(drive.success());
  EXPECT_NEAR(drive.duration, 13.0, 0.05 + 1e-9);
  EXPECT_NEAR(drive.min_wall, 3.0 - 0.325, 1e-9);
  const auto eteb = make_planner("eteb", {});
  const SceneDrive driven =
      drive_scene(corridor_scene(0, 1), ScenePrediction::constant_velocity, *eteb, no_time);
  EXPECT_GE(driven.duration, 12.9) << "it starts by its own acceleration, a little late";
  EXPECT_LE(driven.duration, 13.2);
}

// Somebody who stands in the way, and one who comes to be there in the last moment.
class Standing final : public SceneMovers {
 public:
  explicit Standing(double since) : since_(since) {}
  std::unique_ptr<SceneMovers> clone() const override { return std::make_unique<Standing>(*this); }
  const std::vector<SceneDisc>& discs() const override { return discs_; }
  void step(const SceneRobot&) override {
    time_ += kSceneStep;
    if (time_ >= since_)
      discs_[0] = {.id = 1, .position = {10.0, 0.0}, .velocity = {0.0, 0.0}, .radius = 0.3};
  }

 private:
  double since_;
  double time_ = 0.0;
  std::vector<SceneDisc> discs_{{.id = 0, .position = {10.0, 50.0}, .velocity = {0.0, 0.0}, .radius = 0.3}};
};

// Outlines touch at x = 10 - 0.625 = 9.375 m, after 9.375 / 2 + 0.5 = 5.19 s.
TEST(SceneDrive, TellsContactsAndThoseWithWhoCameSuddenly) {
  for (const auto& [since, sudden] : {std::pair{0.0, 0}, std::pair{4.0, 0}, std::pair{4.6, 1}}) {
    ConstantPlanner planner({2.0, 0.0});
    DriveScene scene = corridor_scene(0, 1);
    scene.movers = std::make_shared<Standing>(since);
    const SceneDrive drive = drive_scene(scene, ScenePrediction::constant_velocity, planner, no_time);
    EXPECT_TRUE(drive.passed) << "a contact does not end it";
    EXPECT_EQ(drive.contacts, 1) << since;
    EXPECT_EQ(drive.sudden_contacts, sudden) << since;
    EXPECT_FALSE(drive.success());
    EXPECT_NEAR(drive.min_gap, -0.625, 0.06) << "through the middle, in steps of 0.1 m";
  }
}

// Told by roll-out, somebody who will turn at their goal is predicted to.
TEST(SceneDrive, RollsOutByTheOthersOwnRule) {
  DriveScene scene = corridor_scene(0, 1);
  scene.movers = std::make_shared<PedsimPeople>(
      std::vector<PedsimPerson>{
          {.position = {20.0, 0.0}, .velocity = {-1.2, 0.0}, .goal = {15.0, 0.0}, .other_goal = {30.0, 0.0}}},
      std::vector<Segment>{}, 0.3);
  ConstantPlanner planner({2.0, 0.0});
  drive_scene(scene, ScenePrediction::roll_out, planner, no_time);
  const Mover& mover = planner.problems.front().movers.front();
  ASSERT_EQ(mover.predictions.size(), 30U) << "6 s in steps of 0.2 s";
  EXPECT_NEAR(mover.predictions[0].position.x(), 20.0 - 0.24, 1e-9);
  EXPECT_GT(mover.predictions.back().position.x(), 20.0);
}

class DynaBarnFiles : public testing::Test {
 protected:
  DynaBarnFiles() { std::filesystem::create_directories(folder); }
  ~DynaBarnFiles() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& rows) const {
    std::ofstream(folder / name) << "# obstacle,radius_m,period_s (repeats),then t:x:y key frames\n" << rows;
  }
  std::string fault(const std::string& rows) const {
    write("world_20.csv", rows);
    try {
      read_dynabarn(folder);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  }
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "bw_dynabarn";
};

// 4 s to and fro would be without a jump; this one is back at its first place at once.
TEST_F(DynaBarnFiles, ObstaclesFollowTheirFramesAndAreOthersAfterAJump) {
  write("world_20.csv", "a,0.50,4.00,0.00:0.00:0.00 2.00:2.00:0.00 4.00:2.00:4.00\n");
  const std::vector<DynaBarnWorld> worlds = read_dynabarn(folder);
  ASSERT_EQ(worlds.size(), 1U);
  EXPECT_EQ(difficulty_of(worlds[0]), "medium");
  const DriveScene scene = dynabarn_scene(worlds[0], 3);
  const std::unique_ptr<SceneMovers> movers = scene.movers->clone();
  const std::uint32_t first = movers->discs()[0].id;
  int jumps = 0;
  for (int k = 0; k < 160; ++k) {
    const SceneDisc before = movers->discs()[0];
    EXPECT_NEAR(before.velocity.norm(), before.position.x() < 2.0 ? 1.0 : 2.0, 1e-9);
    movers->step({});
    const SceneDisc& after = movers->discs()[0];
    if (after.id != before.id)
      ++jumps;
    else
      EXPECT_LE((after.position - before.position).norm(), 0.1 + 1e-9);
  }
  EXPECT_EQ(jumps, 2) << "in 8 s";
  EXPECT_EQ(movers->discs()[0].id, first + 2);
  EXPECT_EQ(dynabarn_scene(worlds[0], 3).movers->discs()[0].position, scene.movers->discs()[0].position);
  EXPECT_NE(dynabarn_scene(worlds[0], 4).movers->discs()[0].position, scene.movers->discs()[0].position);
}

TEST_F(DynaBarnFiles, SayWhatIsWrongInWhichLine) {
  EXPECT_THAT(fault("a,0.5,4.0\n"), testing::HasSubstr("world_20.csv:2: must be name,radius,period,frames"));
  EXPECT_THAT(fault("a,0.5,4.0,0:0:0 x:1:1\n"), testing::HasSubstr(":2: \"x\" is no number"));
  EXPECT_THAT(fault("a,0.5,4.0,0:0:0 4:1\n"), testing::HasSubstr("a frame must be t:x:y"));
  EXPECT_THAT(fault("a,0.5,4.0,0:0:0 0:1:1\n"), testing::HasSubstr("times of frames must rise"));
  EXPECT_THAT(fault("a,0.5,4.0,0:0:0 3:1:1\n"), testing::HasSubstr("from 0 to the period"));
  std::filesystem::remove(folder / "world_20.csv");
  EXPECT_THROW(read_dynabarn(folder), std::runtime_error);
}

// 19 m at 2 m/s after half a second's start: the goal counts from 1 m on.
TEST(DynaBarnScene, IsTwentyMetresAlongTheLine) {
  ConstantPlanner planner({2.0, 0.0});
  const SceneDrive drive =
      drive_scene(dynabarn_scene({"world_0", {}}, 1), ScenePrediction::constant_velocity, planner, no_time);
  EXPECT_TRUE(drive.success());
  EXPECT_NEAR(drive.duration, 19.0 / 2.0 + 0.5, 0.05 + 1e-9);
}

}  // namespace
}  // namespace bw
