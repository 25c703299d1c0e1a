// A callback that throws: the run ends and says where, and every component is brought to rest as at any other
// end, the one that threw first of all. In lock-step and in real time alike.
#include <new>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <std_srvs/srv/trigger.hpp>

#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

using std_srvs::srv::Trigger;
using testing::ElementsAre;
using testing::HasSubstr;

class CallbackFailure : public testing::TestWithParam<ClockMode> {
 protected:
  /// `a`, `b` and `c`, of which `b` does what it likes; how it ended.
  RunEnd run_with(
      const std::function<void(bw::Setup&)>& configure,
      const std::function<void(const Tick&)>& deactivate = [](const Tick&) {},
      const std::shared_ptr<SampleTap>& tap = nullptr) {
    ScriptedGraph g;
    g.add(ComponentNode{.name = "a", .lane = "a"}, [this] {
      Script script = talker(events_, "a");
      script.configure = [](bw::Setup& setup) {
        setup.every(Duration::milliseconds(5), "say",
                    [out = setup.output<Float64>("number")](const Tick&) { out.publish(value(1.0)); });
      };
      return script;
    });
    g.add(ComponentNode{.name = "b", .lane = "b"}, [this, configure, deactivate] {
      return Script{.configure = configure, .deactivate = [this, deactivate](const Tick& tick) {
                      events_.push_back("deactivate b");
                      deactivate(tick);
                    }};
    });
    g.add(ComponentNode{.name = "c", .lane = "b"}, [this] { return talker(events_, "c"); });
    Host host(g.graph, {.clock = GetParam(), .tap = tap});
    const RunEnd end = host.run(Duration::seconds(20.0));
    std::erase_if(events_, [](const std::string& event) { return !event.starts_with("deactivate"); });
    return end;
  }

  Events events_;
};

std::function<void(Setup&)> timer_that(const std::function<void()>& fails) {
  return [fails](Setup& setup) {
    setup.every(Duration::milliseconds(10), "work", [fails](const Tick& tick) {
      if (tick.sequence == 3) fails();
    });
  };
}

TEST_P(CallbackFailure, OfATimerEndsTheRunWithEverybodyAtRest) {
  const RunEnd end = run_with(timer_that([] { throw std::runtime_error("no such wheel"); }));
  EXPECT_FALSE(end.ok);
  EXPECT_TRUE(end.has_thrown);
  EXPECT_EQ(end.reason, "b failed in work: no such wheel");
  EXPECT_THAT(events_, ElementsAre("deactivate b", "deactivate c", "deactivate a"));
}

TEST_P(CallbackFailure, OfAnInputNamesTheTopic) {
  const RunEnd end = run_with([](bw::Setup& setup) {
    setup.input<Float64>("number", Qos::standard(),
                         [](const Float64&, const Tick&) { throw std::bad_alloc(); });
  });
  EXPECT_EQ(end.reason, "b failed in /number: std::bad_alloc");
  EXPECT_THAT(events_, ElementsAre("deactivate b", "deactivate c", "deactivate a"));
}

TEST_P(CallbackFailure, OfAServiceNamesTheService) {
  const RunEnd end = run_with([](bw::Setup& setup) {
    setup.service<Trigger>("push", [](const Trigger::Request&, const Tick&) -> Trigger::Response {
      throw std::logic_error("pushed");
    });
    auto client = std::make_shared<Client<Trigger>>(setup.client<Trigger>("push", Need::optional));
    setup.every(Duration::milliseconds(50), "ask", [client](const Tick&) {
      client->call(Trigger::Request(), Duration::milliseconds(1000),
                   [](const Trigger::Response*, const Tick&) {});
    });
  });
  EXPECT_THAT(end.reason, HasSubstr("b failed in /push"));
  EXPECT_THAT(end.reason, HasSubstr("pushed"));
  EXPECT_THAT(events_, ElementsAre("deactivate b", "deactivate c", "deactivate a"));
}

TEST_P(CallbackFailure, OfWhatIsNoExceptionEndsItToo) {
  const RunEnd end = run_with(timer_that([] { throw 7; }));
  EXPECT_EQ(end.reason, "b failed in work: something that is no std::exception");
  EXPECT_EQ(events_.size(), 3U);
}

TEST_P(CallbackFailure, WhoThrowsWhenItIsBroughtToRestKeepsNobodyFromTheirs) {
  const RunEnd end =
      run_with(timer_that([] { throw std::runtime_error("first"); }), [](const Tick&) { throw 8; });
  EXPECT_EQ(end.reason, "b failed in work: first");
  EXPECT_THAT(events_, ElementsAre("deactivate b", "deactivate c", "deactivate a"));
}

TEST_P(CallbackFailure, ThrowingAtAnOrderlyEndKeepsNobodyFromTheirs) {
  const RunEnd end = run_with(
      [](bw::Setup& setup) {
        setup.every(Duration::milliseconds(10), "work",
                    [finish = setup.finish_run()](const Tick&) { finish(true, "enough"); });
      },
      [](const Tick&) { throw std::runtime_error("stuck"); });
  EXPECT_EQ(end.reason, "b failed at the end: stuck");
  EXPECT_THAT(events_, ElementsAre("deactivate c", "deactivate b", "deactivate a"));
}

/// What a run is told by fails as well.
class FailingLog final : public SampleTap {
 public:
  void connect(const std::vector<const OutputEnd*>&) override {}
  void on_sample(const OutputEnd& output, Time, std::span<const std::uint8_t>) override {
    if (output.topic == "/rosout") throw std::runtime_error("no space left");
  }
};

TEST_P(CallbackFailure, ALogThatFailsTooKeepsNobodyFromTheirs) {
  const RunEnd end = run_with(
      timer_that([] { throw std::runtime_error("no such wheel"); }), [](const Tick&) {},
      std::make_shared<FailingLog>());
  EXPECT_EQ(end.reason, "b failed in work: no such wheel");
  EXPECT_THAT(events_, ElementsAre("deactivate b", "deactivate c", "deactivate a"));
}

// Lanes start when everybody is active. Threads that are to have a stack as large as all of the address space
// of a process (2^47 bytes) are not to be had.
TEST(LaneFailure, OfALaneThatCannotBeStartedEndsTheRunWithEverybodyAtRest) {
  Events events;
  pthread_attr_t usual;
  pthread_getattr_default_np(&usual);
  const auto want_stack = [](std::size_t bytes) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, bytes);
    EXPECT_EQ(pthread_setattr_default_np(&attributes), 0);
    pthread_attr_destroy(&attributes);
  };
  std::size_t usual_size = 0;
  pthread_attr_getstacksize(&usual, &usual_size);
  ScriptedGraph g;
  for (const std::string name : {"a", "b"}) {
    g.add(ComponentNode{.name = name, .lane = name}, [&, name] {
      return Script{.activate = [&](const Tick&) { want_stack(std::size_t{1} << 47); },
                    .deactivate =
                        [&, name](const Tick&) {
                          want_stack(usual_size);
                          events.push_back("deactivate " + name);
                        }};
    });
  }
  Host host(g.graph, {.clock = ClockMode::wall});
  const RunEnd end = host.run(Duration::seconds(20.0));
  want_stack(usual_size);
  EXPECT_TRUE(end.has_thrown);
  EXPECT_THAT(end.reason, HasSubstr("cannot be started: Resource temporarily unavailable"));
  EXPECT_THAT(events, ElementsAre("deactivate b", "deactivate a"));
}

INSTANTIATE_TEST_SUITE_P(Clocks, CallbackFailure, testing::Values(ClockMode::lockstep, ClockMode::wall),
                         [](const auto& clock) {
                           return clock.param == ClockMode::wall ? "RealTime" : "Lockstep";
                         });

}  // namespace
}  // namespace bw::test
