// The world's services for whoever watches: what the ground truth shows of them.
#include <map>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/srv/add_person.hpp>
#include <bandwagon_msgs/srv/push_person.hpp>
#include <gtest/gtest.h>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using bandwagon_msgs::srv::AddPerson;
using bandwagon_msgs::srv::PushPerson;

AddPerson::Request person_at(double x, double y) {
  AddPerson::Request request;
  request.position(to_point({x, y}));
  return request;
}

PushPerson::Request push(std::uint32_t id, double vx) {
  PushPerson::Request request;
  request.id(id);
  request.velocity_change(to_vector3({vx, 0.0}));
  return request;
}

// The request at 1 s leaves the radius open, that at 2 s the speed; the last one is in the way of the first.
// Person 1 is the graph's. The push at 3 s moves person 2 by half a metre (1 m/s times 0.5 s).
TEST(PeopleServices, WhoIsAddedAndPushedIsInTheGroundTruth) {
  const std::string world =
      "components: {world: {inputs: {sim/wheel_commands: {external: true}}, parameters: {people_react: false, "
      "people: {scripted: [{waypoints: [{x: 5, y: 5}]}]}}}}";
  AddPerson::Request walker = person_at(-3.0, -3.0);
  walker.use_goal(true);
  walker.goal(to_point({3.0, -3.0}));
  walker.radius(0.4);
  std::vector<AddPerson::Response> added;
  std::vector<PushPerson::Response> pushed;
  std::map<int, GroundTruth> truths;  ///< by tenths of a second
  run_with_script(world, 6.0, [&](bw::Setup& setup) {
    setup.input<GroundTruth>(
        "sim/ground_truth", Qos::standard(50), [&](const auto& message, const Tick& tick) {
          truths[static_cast<int>(seconds_since_start(tick.now) * 10.0 + 1e-6)] = message;
        });
    call_at<AddPerson>(setup, "add_person",
                       {{1.0, person_at(4.0, 0.0)}, {2.0, walker}, {2.5, person_at(4.4, 0.0)}}, added);
    call_at<PushPerson>(setup, "push_person", {{3.0, push(2, 1.0)}, {3.5, push(7, 1.0)}}, pushed);
  });

  ASSERT_EQ(added.size(), 3U);
  EXPECT_TRUE(added[0].success());
  EXPECT_EQ(added[0].id(), 2U);
  EXPECT_TRUE(added[1].success());
  EXPECT_EQ(added[1].id(), 3U);
  EXPECT_FALSE(added[2].success());
  EXPECT_EQ(added[2].message(), "person 2 stands there");
  ASSERT_EQ(pushed.size(), 2U);
  EXPECT_TRUE(pushed[0].success());
  EXPECT_FALSE(pushed[1].success());
  EXPECT_EQ(pushed[1].message(), "there is no person 7");

  EXPECT_EQ(truths.at(9).people().size(), 1U);
  EXPECT_EQ(truths.at(11).people().size(), 2U);
  const auto& last = truths.rbegin()->second.people();
  ASSERT_EQ(last.size(), 3U);
  const auto of = [&](std::uint32_t id) {
    return *std::find_if(last.begin(), last.end(), [id](const auto& person) { return person.id() == id; });
  };
  EXPECT_EQ(of(1).position().x(), 5.0);
  EXPECT_NEAR(of(2).position().x(), 4.5, 2e-3);  // after 3 s, six times the time in which it fades
  EXPECT_EQ(of(2).radius(), 0.3);
  EXPECT_EQ(of(3).radius(), 0.4);
  EXPECT_GT(of(3).velocity().x(), 0.9);
}

}  // namespace
}  // namespace bw
