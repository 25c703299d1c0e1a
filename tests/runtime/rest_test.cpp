// How long a run in real time goes on after it was asked to end: until what it commands stands. Callbacks are
// the clock of these tests: a timer of 10 ms that is late ticks once, so a busy machine makes fewer of them,
// never more.
#include <cmath>

#include <geometry_msgs/msg/twist_stamped.hpp>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>

#include "runtime/host/commanded_motion.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/runtime/test_graph.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::TwistStamped;
using sensor_msgs::msg::JointState;

template <class M>
bool is_motion(const M& message) {
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  CommandedMotion motion;
  motion.see({MessageTraits<M>::ros_name, MessageTraits<M>::dds_name, MessageTraits<M>::type_hash}, cdr,
             Duration::seconds(1.0));
  return !motion.is_over_since(Duration::milliseconds(1), Duration::seconds(1.0));
}

TEST(CommandedMotion, IsAnyNumberOfACommandButOfItsHeader) {
  TwistStamped twist;
  twist.header().stamp().sec(7);
  twist.header().frame_id("base_link");
  EXPECT_FALSE(is_motion(twist));
  twist.twist().angular().z(-1e-9);
  EXPECT_TRUE(is_motion(twist));
  twist.twist().angular().z(std::nan(""));
  EXPECT_TRUE(is_motion(twist));
  JointState wheels;
  wheels.name({"left", "right"});
  wheels.velocity({0.0, -0.0});
  EXPECT_FALSE(is_motion(wheels));
  wheels.velocity({0.0, 0.1});
  EXPECT_TRUE(is_motion(wheels));
}

TEST(CommandedMotion, MayBeWhatNobodyCanRead) {
  CommandedMotion motion;
  const std::vector<std::uint8_t> cdr = {0, 1, 0, 0, 0};
  EXPECT_TRUE(motion.is_over_since(Duration::seconds(9.0), Duration::seconds(1.0)))
      << "nothing was commanded";
  motion.see({"other_msgs/msg/Thrust", "other_msgs::msg::dds_::Thrust_", "RIHS01_1"}, cdr,
             Duration::seconds(1.0));
  EXPECT_FALSE(motion.is_over_since(Duration::milliseconds(200), Duration::seconds(1.1)));
  EXPECT_TRUE(motion.is_over_since(Duration::milliseconds(200), Duration::seconds(1.2)));
}

struct Trolley {
  double rest = 0.0;  ///< [s]
  void fields(auto& v) { v("rest", rest, {.unit = "s", .min = 0, .max = 100, .doc = "time to rest"}); }
  Duration time_to_rest() const { return Duration::seconds(rest); }
};

/// Callbacks after the run was asked to end. `speed` is commanded in the n-th of them.
int callbacks_to_rest(double time_to_rest, const std::function<double(int n)>& speed) {
  int stops = 0;
  Host* running = nullptr;
  TestGraph builder;
  builder.add({.name = "trolley"}, [&](bw::Setup& setup) {
    Trolley trolley{time_to_rest};
    setup.shared<Trolley>("trolley", trolley);
    setup.every(Duration::milliseconds(10), "drive",
                [&, out = setup.command<TwistStamped>("cmd_vel")](const Tick& tick) mutable {
                  if (tick.health == Health::stop) ++stops;
                  TwistStamped command;
                  command.twist().linear().x(speed(stops));
                  out.publish(command);
                  if (tick.sequence == 10) running->finish({.ok = true, .reason = "asked"}, false);
                });
  });
  Graph graph = builder.graph();
  graph.shared["trolley"].kind = ConfigNode::Kind::kMap;
  Host host(graph, {.clock = ClockMode::wall});
  running = &host;
  EXPECT_EQ(host.run(Duration::seconds(120.0)).reason, "asked");
  return stops;
}

// 20 s are 2000 callbacks.
TEST(Rest, IsOverWhenTheCommandsAreZero) {
  const int stops = callbacks_to_rest(20.0, [](int n) { return n < 20 ? 0.5 : 0.0; });
  EXPECT_GE(stops, 20);
  EXPECT_LT(stops, 1000);
}

// 10 s are 1000 callbacks.
TEST(Rest, TakesNoTimeWhereNothingMoves) {
  EXPECT_LT(callbacks_to_rest(10.0, [](int) { return 0.0; }), 100);
}

// Half a second is 50 callbacks, fewer on a busy machine.
TEST(Rest, IsLeftToTheRobotsTimeByWhoNeverStops) {
  const int stops = callbacks_to_rest(0.5, [](int) { return 0.5; });
  EXPECT_GE(stops, 5);
  EXPECT_LE(stops, 60);
}

// A recording may still be written then.
TEST(Rest, IsFollowedByTheLeaveFromTheWire) {
  const dds::Participant outside({.network = dds::Network::from_environment({})});
  TestGraph builder;
  builder.add({.name = "guest"}, [&](bw::Setup& setup) {
    setup.every(Duration::milliseconds(10), "look", [&, finish = setup.finish_run()](const Tick&) {
      if (!outside.remote_participants().empty()) finish(true, "seen");
    });
  });
  Host host(builder.graph(), {.clock = ClockMode::wall});
  EXPECT_EQ(host.run(Duration::seconds(60.0)).reason, "seen");
  EXPECT_TRUE(test::eventually([&] { return outside.remote_participants().empty(); }));
}

}  // namespace
}  // namespace bw
