// The host with fake components over real topics, in lock-step. Expected times and orders follow from the
// rules in lockstep_runner.hpp.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/msg/string.hpp>

#include "runtime/host/lockstep_runner.hpp"
#include "tests/runtime/test_graph.hpp"

namespace bw {
namespace {

using Float64 = std_msgs::msg::Float64;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Lockstep, DeliversAtTheInstantOfPublicationInRankOrder) {
  std::vector<std::string> seen;
  const auto listener = [&](const std::string& name) {
    return [&seen, name](bw::Setup& setup) {
      setup.input<Float64>("a", Qos::standard(), [&seen, name](const Float64& m, const Tick& tick) {
        seen.push_back(name + std::to_string(static_cast<int>(m.data())) + "@" +
                       std::to_string(ms(tick.now)));
      });
    };
  };
  TestGraph graph;
  graph.add({.name = "first"}, listener("first"))
      .add({.name = "source"}, ticker("a", 10))
      .add({.name = "last"}, listener("last"));
  graph.run(0.02);
  EXPECT_THAT(seen, ElementsAre("first0@10", "last0@10", "first1@20", "last1@20"));
}

TEST(Lockstep, DeclaredLatencyHoldsOutputsAndDefersInputs) {
  // Source at 10, 20, ... ms; worker is busy for 25 ms. Call at 10: out at 35. Samples of 20 and 30 wait; at
  // 35 the first of them is worked on (out at 60) while 40, 50, 60 queue up behind the other one.
  std::vector<std::int64_t> called_at;
  std::vector<std::string> out;
  TestGraph graph;
  graph.add({.name = "source"}, ticker("a", 10))
      .add({.name = "worker", .latency = Duration::milliseconds(25)},
           [&](bw::Setup& setup) {
             setup.input<Float64>("a", Qos::standard(),
                                  [&called_at, result = setup.output<Float64>("b")](
                                      const Float64& m, const Tick& tick) mutable {
                                    called_at.push_back(ms(tick.now));
                                    result.publish(m);
                                  });
           })
      .add({.name = "sink"}, [&](bw::Setup& setup) {
        setup.input<Float64>("b", Qos::standard(), [&](const Float64& m, const Tick& tick) {
          out.push_back(std::to_string(static_cast<int>(m.data())) + "@" + std::to_string(ms(tick.now)));
        });
      });
  graph.run(0.085);
  EXPECT_THAT(called_at, ElementsAre(10, 35, 60, 85));
  EXPECT_THAT(out, ElementsAre("0@35", "1@60", "2@85"));
}

TEST(Lockstep, TicksMissedWhileBusyBecomeOne) {
  // Period 10, latency 35: called at 10; ticks 20, 30, 40 become one at 45; ticks 50, 60, 70 and 80 become
  // one at 80.
  std::vector<std::int64_t> called_at;
  TestGraph graph;
  graph.add({.name = "slow", .latency = Duration::milliseconds(35)}, [&](bw::Setup& setup) {
    setup.every(Duration::milliseconds(10), "tick",
                [&](const Tick& tick) { called_at.push_back(ms(tick.now)); });
  });
  graph.run(0.08);
  EXPECT_THAT(called_at, ElementsAre(10, 45, 80));
  EXPECT_EQ(graph.statistics("slow", "tick").missed, 2U + 2U);
}

// The worker is busy from 10 to 30 ms. What waited since 10 comes before what is said at 30, whether that is
// said before or after the worker is free again: a replay, which says everything at the beginning of an
// instant, has the same order.
TEST(Lockstep, WhatWaitedComesBeforeWhatArrives) {
  for (const bool speaks_first : {true, false}) {
    std::vector<double> heard;
    const auto worker = [&heard](bw::Setup& setup) {
      setup.input<Float64>("said", Qos::standard(),
                           [&heard](const Float64& m, const Tick&) { heard.push_back(m.data()); });
      setup.input<Float64>("said_later", Qos::standard(),
                           [&heard](const Float64& m, const Tick&) { heard.push_back(m.data()); });
    };
    const auto speaker = [](bw::Setup& setup) {
      const auto said = setup.output<Float64>("said");
      const auto later = setup.output<Float64>("said_later");
      setup.every(Duration::milliseconds(10), "speak", [said, later](const Tick& tick) {
        if (tick.sequence == 0) said.publish(value(1.0));
        if (tick.sequence == 0) said.publish(value(2.0));
        if (tick.sequence == 2) later.publish(value(3.0));
      });
    };
    const ComponentNode busy{.name = "worker", .latency = Duration::milliseconds(20)};
    TestGraph graph;
    if (speaks_first) graph.add({.name = "speaker"}, speaker);
    graph.add(busy, worker);
    if (!speaks_first) graph.add({.name = "speaker"}, speaker);
    graph.run(0.1);
    EXPECT_THAT(heard, ElementsAre(1.0, 2.0, 3.0)) << (speaks_first ? "said before" : "said after");
  }
}

TEST(Lockstep, LatestInputsCostNoLatencyAndAreFreshEvenWhileBusy) {
  std::vector<double> seen;
  TestGraph graph;
  graph.add({.name = "source"}, ticker("a", 5))
      .add({.name = "user", .latency = Duration::milliseconds(20)}, [&](bw::Setup& setup) {
        setup.every(Duration::milliseconds(30), "tick",
                    [&seen, a = setup.latest<Float64>("a", Qos::command())](const Tick&) {
                      seen.push_back(a->data());
                    });
      });
  graph.run(0.06);
  // The tick of 30 ms was scheduled before the sample of 30 ms was sent, so it still sees the one of 25 ms
  // (number 4).
  EXPECT_THAT(seen, ElementsAre(4.0, 10.0));
}

TEST(Lockstep, SameSeedSameBytesOtherSeedOtherBytes) {
  const auto run = [](std::uint64_t seed) {
    TestGraph graph;
    graph.add({.name = "noise"}, [](bw::Setup& setup) {
      setup.every(Duration::milliseconds(1), "tick",
                  [out = setup.output<Float64>("n"), state = setup.seed()](const Tick&) mutable {
                    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
                    out.publish(value(static_cast<double>(state >> 11U)));
                  });
    });
    return graph.run(0.5, seed);
  };
  const std::string first = run(7);
  EXPECT_EQ(first.size(), 64U);
  EXPECT_EQ(run(7), first);
  EXPECT_NE(run(8), first);
}

TEST(Lockstep, AWriterFromOutsideChangesNothing) {
  const auto run = [](bool disturbed) {
    std::unique_ptr<dds::Participant> outside;
    std::unique_ptr<dds::Writer> writer;
    std::unique_ptr<dds::Reader> reader;
    int heard = 0;
    if (disturbed) {
      outside = std::make_unique<dds::Participant>(
          dds::ParticipantOptions{.network = dds::Network::from_environment({})});
      const dds::EndpointOptions a{.topic = "rt/a",
                                   .type = std::string(MessageTraits<Float64>::dds_name),
                                   .qos = Qos::latched(),
                                   .user_data = {}};
      writer = outside->create_writer(a);
      std::vector<std::uint8_t> cdr;
      serialize(value(99.0), cdr);
      writer->write(cdr);
      dds::EndpointOptions b = a;
      b.topic = "rt/b";
      b.qos = Qos::standard();
      reader = outside->create_reader(b, [] {});
    }
    TestGraph graph;
    graph.add({.name = "source"}, ticker("a", 10)).add({.name = "echo"}, [](bw::Setup& setup) {
      setup.input<Float64>(
          "a", Qos::standard(),
          [out = setup.output<Float64>("b")](const Float64& m, const Tick&) mutable { out.publish(m); });
    });
    // Paced by the outside reader's match: the run goes on in virtual time until discovery has surely
    // happened.
    Host host(graph.graph(), {.clock = ClockMode::lockstep, .seed = 1, .pace = disturbed ? 1.0 : 0.0});
    host.run(Duration::seconds(2.0));
    dds::Sample sample;
    while (reader && reader->take(sample)) ++heard;
    if (disturbed) {
      EXPECT_GT(heard, 0) << "an outside viewer sees the run";
      EXPECT_EQ(writer->matched_readers(), 0) << "an outside writer is not heard";
    }
    return host.samples_sha256();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(Lockstep, ARunThatIsAloneIsTheSameToTheByteAndNobodySeesIt) {
  const auto run = [](bool alone) {
    dds::Participant outside({.network = dds::Network::from_environment({})});
    TestGraph graph;
    graph.add({.name = "source"}, ticker("a", 10)).add({.name = "echo"}, [](bw::Setup& setup) {
      setup.input<Float64>(
          "a", Qos::standard(),
          [out = setup.output<Float64>("b")](const Float64& m, const Tick&) mutable { out.publish(m); });
    });
    // Two seconds of real time: within one, who is there has been announced.
    Host host(graph.graph(), {.clock = ClockMode::lockstep, .seed = 1, .pace = 1.0, .alone = alone});
    std::size_t seen = 0;
    host.run(Duration::seconds(2.0));
    for (const dds::Endpoint& end : outside.endpoints()) seen += end.is_local ? 0 : 1;
    return std::pair(host.samples_sha256(), seen > 0);
  };
  const auto alone = run(true), open = run(false);
  EXPECT_EQ(alone.first, open.first);
  EXPECT_FALSE(alone.second);
  EXPECT_TRUE(open.second);
}

TEST(Lockstep, ALoopAtOneInstantIsAnErrorThatNamesIt) {
  TestGraph graph;
  const auto echo = [](const char* from, const char* to) {
    return [=](bw::Setup& setup) {
      setup.input<Float64>(
          from, Qos::standard(),
          [out = setup.output<Float64>(to)](const Float64& m, const Tick&) mutable { out.publish(m); });
    };
  };
  graph.add({.name = "ping"}, echo("a", "b"))
      .add({.name = "pong"}, echo("b", "a"))
      .add({.name = "start"}, ticker("a", 10));
  try {
    graph.run(1.0);
    FAIL() << "the loop ran";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("ping (/a)"), HasSubstr("pong (/b)")));
  }
}

TEST(Lockstep, AStaleInputTurnsHealthToStop) {
  // One sample at 10 ms, then silence; max_age 25 ms: ok until 35 ms inclusive, stop from 40 ms on.
  std::vector<std::int64_t> stopped_at;
  TestGraph graph;
  ComponentNode guard{.name = "guard"};
  guard.inputs.push_back({.name = "a", .max_age = Duration::milliseconds(25), .on_stale = OnStale::stop});
  graph
      .add({.name = "source"},
           [](bw::Setup& setup) {
             setup.every(Duration::milliseconds(10), "tick",
                         [out = setup.output<Float64>("a")](const Tick& tick) mutable {
                           if (tick.sequence == 0) out.publish(value(1.0));
                         });
           })
      .add(guard, [&](bw::Setup& setup) {
        setup.every(Duration::milliseconds(5), "tick",
                    [&, a = setup.latest<Float64>("a", Qos::command())](const Tick& tick) {
                      if (tick.health == Health::stop) stopped_at.push_back(ms(tick.now));
                    });
      });
  graph.run(0.05);
  EXPECT_THAT(stopped_at, ElementsAre(40, 45, 50));
}

}  // namespace
}  // namespace bw
