#include "components/local_planner/orca/orca.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::orca {
namespace {

Agent agent_at(const Vector2& position, const Vector2& velocity, const Vector2& wanted) {
  return {.position = position, .velocity = velocity, .radius = 0.3, .wanted = wanted, .v_max = 1.0};
}

TEST(Orca, WantsItsWayWhereNobodyIs) {
  EXPECT_EQ(advise(agent_at({0, 0}, {0, 0}, {0.5, 0.2}), {}, {}, {}).velocity, Vector2(0.5, 0.2));
}

TEST(Orca, LooksAtTheNearestNeighboursWithinRange) {
  const Agent agent = agent_at({0, 0}, {1, 0}, {1, 0});
  const Neighbour far{{10.5, 0.0}, {-1.0, 0.0}, 0.3, 0.5};
  const Neighbour near{{3.0, 0.1}, {-1.0, 0.0}, 0.3, 0.5};
  EXPECT_EQ(advise(agent, {far}, {}, {.horizon = 20.0}).velocity, Vector2(1.0, 0.0));
  EXPECT_NE(advise(agent, {near}, {}, {}).velocity, Vector2(1.0, 0.0));
  const Neighbour aside{{0.0, 1.5}, {0.0, 0.0}, 0.3, 0.5};
  EXPECT_EQ(advise(agent, {near, aside}, {}, {.max_neighbours = 1}).velocity,
            advise(agent, {aside}, {}, {}).velocity);
}

TEST(Orca, DoesNotDependOnTheOrderOfNeighbours) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    std::vector<Neighbour> all;
    for (int k = 0; k < 12; ++k)
      all.push_back({{std::round(random.uniform(-4.0, 4.0)), std::round(random.uniform(-4.0, 4.0))},
                     {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)},
                     0.3,
                     0.5});
    const Agent agent = agent_at({0.1, 0.2}, {0.5, 0.0}, {1, 0});
    std::vector<Neighbour> reversed(all.rbegin(), all.rend());
    EXPECT_EQ(advise(agent, all, {}, {}).velocity, advise(agent, reversed, {}, {}).velocity) << i;
  }
}

// On a circle, each to the opposite position: the rule promises that nobody touches. Not that all arrive:
// more than two can wait for each other in the middle.
TEST(Orca, DiscsThatAllFollowItNeverTouch) {
  for (const int count : {2, 3, 10}) {
    std::vector<Agent> agents;
    std::vector<Vector2> goals;
    for (int k = 0; k < count; ++k) {
      const Vector2 position = 4.0 * direction(2.0 * M_PI * k / count + 0.01 * k);
      agents.push_back(agent_at(position, {0, 0}, {0, 0}));
      goals.push_back(-position);
    }
    double least = 1e9;
    constexpr double kStep = 0.1;
    for (int step = 0; step < 600; ++step) {
      std::vector<Vector2> next;
      for (std::size_t i = 0; i < agents.size(); ++i) {
        std::vector<Neighbour> others;
        for (std::size_t j = 0; j < agents.size(); ++j)
          if (j != i) others.push_back({agents[j].position, agents[j].velocity, agents[j].radius, 0.5});
        const Vector2 to_goal = goals[i] - agents[i].position;
        agents[i].wanted = to_goal.norm() > 1.0 ? Vector2(to_goal.normalized()) : to_goal;
        next.push_back(advise(agents[i], others, {}, {.time_step = kStep}).velocity);
      }
      for (std::size_t i = 0; i < agents.size(); ++i) {
        agents[i].velocity = next[i];
        agents[i].position += kStep * next[i];
        for (std::size_t j = 0; j < i; ++j)
          least = std::min(least, (agents[i].position - agents[j].position).norm() - 0.6);
      }
    }
    EXPECT_GE(least, -1e-6) << count;
    for (std::size_t i = 0; count == 2 && i < agents.size(); ++i)
      EXPECT_LE((agents[i].position - goals[i]).norm(), 0.3) << count << " " << i;
  }
}

// 1 m/s at a wall 2 m ahead that 0.3 m are kept from, 2 s ahead: at most 1.7 / 2 m/s towards it, along it
// freely.
TEST(Orca, BrakesBeforeAWallAndSlidesAlongIt) {
  const Wall wall{{{2.0, -50.0}, {2.0, 50.0}}, 0.3};
  const Rule rule{.wall_horizon = 2.0};
  const Advice ahead = advise(agent_at({0, 0}, {0.8, 0.0}, {1.0, 0.0}), {}, {wall}, rule);
  EXPECT_NEAR(ahead.velocity.x(), 0.85, 1e-9);
  const Advice along = advise(agent_at({0, 0}, {0.5, 0.5}, {0.9, 0.4}), {}, {wall}, rule);
  EXPECT_TRUE(along.velocity.isApprox(Vector2(0.85, 0.4), 1e-9)) << along.velocity.transpose();
}

// Somebody pushes the agent against a wall: rather the person's half plane is violated than the wall's.
TEST(Orca, IsNotPushedThroughAWall) {
  const Wall wall{{{0.35, -50.0}, {0.35, 50.0}}, 0.3};
  const Neighbour pusher{{-0.7, 0.0}, {1.0, 0.0}, 0.3, 1.0};
  const Advice choice = advise(agent_at({0, 0}, {0, 0}, {0, 0}), {pusher}, {wall}, {.wall_horizon = 1.0});
  EXPECT_LE(choice.velocity.x(), 0.05 + 1e-9);
}

}  // namespace
}  // namespace bw::orca
