// The host with fake components over real topics: what it refuses, and the clocks that run in real time.
#include "runtime/host/host.hpp"

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/msg/clock.hpp>
#include <std_msgs/msg/string.hpp>

#include "runtime/stamps.hpp"
#include "tests/runtime/test_graph.hpp"

namespace bw {
namespace {

using Float64 = std_msgs::msg::Float64;
using testing::HasSubstr;

TEST(Host, RefusesTwoOwnersOfACommandAndOpenInputs) {
  Graph graph;
  const auto commander = [](bw::Setup& setup) { setup.command<Float64>("motor"); };
  TestGraph builder;
  builder.add({.name = "one"}, commander)
      .add({.name = "two"}, commander)
      .add({.name = "three"}, [](bw::Setup& setup) { setup.latest<Float64>("nobody", Qos::standard()); });
  try {
    const Host host(builder.graph(), {});
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("motor"), HasSubstr("nobody")));
  }
}

TEST(Host, LeavesOutWhatIsNotEnabled) {
  const auto commander = [](bw::Setup& setup) { setup.command<Float64>("motor"); };
  TestGraph builder;
  builder.add({.name = "one"}, commander).add({.name = "two", .enabled = false}, commander);
  const Host host(builder.graph(), {});
  EXPECT_EQ(host.graph().components.size(), 1U);
  EXPECT_EQ(host.graph().components[0].name, "one");
}

TEST(Host, RefusesLockstepForOneProcessOfMany) {
  TestGraph builder;
  builder.add({.name = "only"}, [](bw::Setup&) {});
  EXPECT_THROW(Host(builder.graph(), {.clock = ClockMode::lockstep, .only_process = "main"}),
               std::runtime_error);
}

// As by Ctrl-C while the program starts: before there was a runner it was lost, and the robot drove on.
TEST(Host, AnEndAskedForBeforeTheRunEndsIt) {
  for (const ClockMode clock : {ClockMode::wall, ClockMode::lockstep}) {
    TestGraph builder;
    builder.add({.name = "only"}, [](bw::Setup&) {});
    Host host(builder.graph(), {.clock = clock});
    host.finish({.ok = true, .reason = "interrupted"}, false);
    EXPECT_EQ(host.run(Duration::seconds(5.0)).reason, "interrupted");
  }
}

TEST(WallClock, LanesExchangeMessagesAndFinishEndsTheRun) {
  constexpr int kRounds = 200;
  TestGraph builder;
  builder
      .add({.name = "left", .lane = "left"},
           [](bw::Setup& setup) {
             auto out = std::make_shared<Output<Float64>>(setup.output<Float64>("to_right"));
             setup.input<Float64>("to_left", Qos::standard(), [out](const Float64& m, const Tick&) {
               out->publish(value(m.data() + 1));
             });
             setup.every(Duration::milliseconds(5), "start", [out](const Tick& tick) {
               if (tick.sequence == 0) out->publish(value(0));
             });
           })
      .add({.name = "right", .lane = "right"}, [](bw::Setup& setup) {
        setup.input<Float64>("to_right", Qos::standard(),
                             [out = setup.output<Float64>("to_left"), finish = setup.finish_run()](
                                 const Float64& m, const Tick&) mutable {
                               if (m.data() >= kRounds) finish(true, "enough");
                               out.publish(m);
                             });
      });
  Host host(builder.graph(), {.clock = ClockMode::wall});
  const RunEnd end = host.run(Duration::seconds(30));
  EXPECT_EQ(end.reason, "enough");
  for (const CallbackStatistics& s : host.statistics()) {
    if (s.component != "right") continue;
    EXPECT_GE(s.run.count(), static_cast<std::uint64_t>(kRounds));
  }
}

TEST(TopicClock, TimersFollowTheClockFromOutside) {
  // /clock advances by 10 ms from 100 s on: a timer of 50 ms ticks at multiples of 50 ms after the first
  // stamp that was heard.
  std::vector<Time> ticks;
  TestGraph builder;
  builder.add({.name = "user"}, [&](bw::Setup& setup) {
    setup.every(Duration::milliseconds(50), "tick", [&ticks, finish = setup.finish_run()](const Tick& tick) {
      ticks.push_back(tick.now);
      if (ticks.size() == 20) finish(true, "enough");
    });
  });
  std::atomic<bool> done = false;
  std::thread outside([&done] {
    dds::Participant participant({.network = dds::Network::from_environment({})});
    const auto writer =
        participant.create_writer({.topic = "rt/clock",
                                   .type = std::string(MessageTraits<rosgraph_msgs::msg::Clock>::dds_name),
                                   .qos = Qos::standard(),
                                   .user_data = {}});
    std::vector<std::uint8_t> cdr;
    for (Time now = Time::seconds(100.0); !done; now = now + Duration::milliseconds(10)) {
      rosgraph_msgs::msg::Clock message;
      message.clock(to_stamp(now));
      serialize(message, cdr);
      writer->write(cdr);
      std::this_thread::yield();
    }
  });
  Host host(builder.graph(), {.clock = ClockMode::topic});
  const RunEnd end = host.run(Duration::seconds(60));
  done = true;
  outside.join();
  EXPECT_EQ(end.reason, "enough");
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    EXPECT_GT(ticks[i], ticks[i - 1]);
    EXPECT_EQ(ticks[i].nanoseconds % 10'000'000, 0) << "a stamp of the clock, not a time of our own";
  }
}

TEST(WallClock, RejectsASampleThatIsNotTheMessageAndGoesOn) {
  TestGraph builder;
  builder.add({.name = "reader"}, [](bw::Setup& setup) {
    setup.input<std_msgs::msg::String>(
        "text", Qos::latched(),
        [finish = setup.finish_run()](const auto& m, const Tick&) {
          finish(m.data() == "good", "heard " + m.data());
        },
        Need::optional);
  });
  dds::Participant outside({.network = dds::Network::from_environment({})});
  Qos qos = Qos::latched();
  qos.depth = 2;
  const auto writer =
      outside.create_writer({.topic = "rt/text",
                             .type = std::string(MessageTraits<std_msgs::msg::String>::dds_name),
                             .qos = qos,
                             .user_data = {}});
  const std::vector<std::uint8_t> hostile = {0,    1,    0,    0,
                                             0xff, 0xff, 0xff, 0x7f};  // a string of 2 GiB, claimed
  writer->write(hostile);
  std_msgs::msg::String good;
  good.data("good");
  std::vector<std::uint8_t> cdr;
  serialize(good, cdr);
  writer->write(cdr);
  Graph graph = builder.graph();
  Host host(graph, {.clock = ClockMode::wall});
  EXPECT_EQ(host.run(Duration::seconds(30)).reason, "heard good");
}

}  // namespace
}  // namespace bw
