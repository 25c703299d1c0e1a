// The parameter services of a node, from another component of the run, in lock-step. Semantics: rclcpp's.
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rcl_interfaces/msg/parameter_event.hpp>
#include <rcl_interfaces/srv/describe_parameters.hpp>
#include <rcl_interfaces/srv/get_parameter_types.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>
#include <rcl_interfaces/srv/list_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters_atomically.hpp>
#include <std_msgs/msg/float64.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/ros/parameter_messages.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

using namespace rcl_interfaces::srv;
using rcl_interfaces::msg::ParameterEvent;
using std_msgs::msg::Float64;
using testing::ElementsAre;
using testing::IsEmpty;

struct Options {
  double gain = 1.0;
  double rate = 10.0;
  std::vector<double> weights = {0.5};

  void fields(auto& v) {
    v("gain", gain, {.unit = "1/s", .min = 0, .max = 5, .doc = "what is published"});
    v("rate", rate, {.min = 1, .max = 100});
    v("weights", weights);
  }
  std::optional<std::string> violated_rule() const {
    if (gain > rate) return "gain must not exceed rate";
    return std::nullopt;
  }
};

struct Body {
  double radius = 0.2;
  void fields(auto& v) { v("radius", radius); }
};

/// Publishes its gain ten times a second.
class GainPublisher final : public Component {
  void configure(bw::Setup& setup) override {
    options_ = setup.parameters<Options>([this](const Options& changed, const Tick&) { options_ = changed; },
                                         {"rate"});
    setup.shared<Body>("body");
    setup.every(Duration::milliseconds(100), "publish",
                [this, out = setup.output<Float64>("gain")](const Tick&) mutable {
                  Float64 message;
                  message.data(options_.gain);
                  out.publish(message);
                });
  }
  Options options_;
};

BW_COMPONENT(GainPublisher, "gain_publisher")

class Script final : public Component {
 public:
  explicit Script(std::function<void(Setup&)> script) : script_(std::move(script)) {}
  void configure(bw::Setup& setup) override { script_(setup); }

 private:
  std::function<void(Setup&)> script_;
};

/// One node with parameters, and a client that calls at 250 ms.
class Client {
 public:
  std::vector<double> gains;  ///< published, one each 100 ms
  std::vector<ParameterEvent> events;
  std::string hash;
  Duration latency;  ///< of the node

  template <class S>
  typename S::Response call(const std::string& service, const typename S::Request& request) {
    std::optional<typename S::Response> answer;
    run([&](bw::Setup& setup) {
      auto client = setup.client<S>("/robot1/publisher/" + service);
      setup.every(Duration::milliseconds(250), "call", [&answer, client, request](const Tick& tick) {
        if (tick.sequence > 0) return;
        client.call(request, Duration::milliseconds(100), [&answer](const auto* response, const Tick&) {
          if (response != nullptr) answer = *response;
        });
      });
    });
    EXPECT_TRUE(answer) << service << " did not answer";
    return answer.value_or(typename S::Response{});
  }

  void run(std::function<void(Setup&)> script) {
    Graph graph;
    graph.components.push_back(
        {.name = "publisher", .type = "gain_publisher", .latency = latency, .node_namespace = "/robot1"});
    std::vector<ExtraComponent> extra;
    extra.push_back(
        {"client", std::make_unique<Script>([this, script](bw::Setup& setup) {
           setup.input<Float64>("/robot1/gain", Qos::standard(),
                                [this](const Float64& m, const Tick&) { gains.push_back(m.data()); });
           setup.input<ParameterEvent>(
               "/parameter_events", Qos::standard(1000),
               [this](const ParameterEvent& m, const Tick&) { events.push_back(m); }, Need::optional);
           if (script) script(setup);
         })});
    gains.clear();
    events.clear();
    Host host(graph, {.clock = ClockMode::lockstep}, std::move(extra));
    host.run(Duration::milliseconds(500));
    hash = host.samples_sha256();
  }
};

template <class Request>
Request named(const std::vector<std::string>& names) {
  Request request;
  request.names(names);
  return request;
}

template <class Request>
Request with(const std::vector<NamedValue>& parameters) {
  Request request;
  for (const NamedValue& parameter : parameters) request.parameters().push_back(to_message(parameter));
  return request;
}

std::vector<std::string> reasons(const SetParameters::Response& response) {
  std::vector<std::string> reasons;
  for (const auto& result : response.results()) {
    EXPECT_EQ(result.successful(), result.reason().empty());
    reasons.push_back(result.reason());
  }
  return reasons;
}

const std::vector<std::string> kNames = {"gain", "rate", "weights", "body.radius", "use_sim_time"};
const std::string kFixed = " may not change while publisher is active; deactivate and clean up first";

TEST(ParameterServices, ListNamesAndSections) {
  Client client;
  const auto all = client.call<ListParameters>("list_parameters", {});
  EXPECT_EQ(all.result().names(), kNames);
  EXPECT_THAT(all.result().prefixes(), ElementsAre("body"));
  ListParameters::Request below;
  below.prefixes({"body"});
  EXPECT_THAT(client.call<ListParameters>("list_parameters", below).result().names(),
              ElementsAre("body.radius"));
}

TEST(ParameterServices, TellValuesAndTypesInTheOrderAskedFor) {
  Client client;
  const auto values = client.call<GetParameters>(
      "get_parameters", named<GetParameters::Request>({"use_sim_time", "gain", "weights", "gain"}));
  ASSERT_EQ(values.values().size(), 4U);
  EXPECT_EQ(from_message(values.values()[0]), ParameterValue(true));
  EXPECT_EQ(from_message(values.values()[1]), ParameterValue(1.0));
  EXPECT_EQ(from_message(values.values()[2]), ParameterValue(std::vector<double>{0.5}));
  const auto types =
      client.call<GetParameterTypes>("get_parameter_types", named<GetParameterTypes::Request>(kNames));
  EXPECT_THAT(types.types(), ElementsAre(3, 3, 8, 3, 1));
}

TEST(ParameterServices, AnswerAnUnknownNameWithAnEmptyList) {
  Client client;
  const std::vector<std::string> names = {"gain", "gian"};
  EXPECT_THAT(client.call<GetParameters>("get_parameters", named<GetParameters::Request>(names)).values(),
              IsEmpty());
  EXPECT_THAT(
      client.call<GetParameterTypes>("get_parameter_types", named<GetParameterTypes::Request>(names)).types(),
      IsEmpty());
  EXPECT_THAT(
      client.call<DescribeParameters>("describe_parameters", named<DescribeParameters::Request>(names))
          .descriptors(),
      IsEmpty());
}

TEST(ParameterServices, DescribeWhatMayChange) {
  Client client;
  const auto described =
      client.call<DescribeParameters>("describe_parameters", named<DescribeParameters::Request>(kNames))
          .descriptors();
  ASSERT_EQ(described.size(), 5U);
  EXPECT_EQ(described[0].description(), "what is published [1/s]");
  EXPECT_EQ(described[0].floating_point_range().at(0).to_value(), 5.0);
  std::vector<std::string> constraints;
  for (const auto& descriptor : described) constraints.push_back(descriptor.additional_constraints());
  EXPECT_THAT(constraints, ElementsAre("default 1.0", "default 10.0", "default [0.5]", "", ""));
  std::vector<bool> read_only;
  for (const auto& descriptor : described) read_only.push_back(descriptor.read_only());
  EXPECT_THAT(read_only, ElementsAre(false, true, false, true, true));
}

// Publications at 100, 200, ... ms; the change at 250 ms.
TEST(ParameterServices, ChangeWhatTheComponentDoesNext) {
  Client client;
  const auto response = client.call<SetParameters>(
      "set_parameters", with<SetParameters::Request>({{"gain", 2.0}, {"weights", std::vector<double>{0.5}}}));
  EXPECT_THAT(reasons(response), ElementsAre("", ""));
  EXPECT_THAT(client.gains, ElementsAre(1.0, 1.0, 2.0, 2.0, 2.0));
  ASSERT_EQ(client.events.size(), 1U);
  const ParameterEvent& event = client.events[0];
  EXPECT_EQ(event.node(), "/robot1/publisher");
  EXPECT_EQ(from_stamp(event.stamp()) - LockstepRunner::kStart, Duration::milliseconds(250));
  ASSERT_EQ(event.changed_parameters().size(), 1U);  // weights stayed as they were
  EXPECT_EQ(from_messages(event.changed_parameters())[0], (NamedValue{"gain", 2.0}));
  EXPECT_TRUE(event.new_parameters().empty() && event.deleted_parameters().empty());
}

TEST(ParameterServices, RefuseEachForItsOwnReason) {
  Client client;
  const std::vector<NamedValue> bad = {{"gain", std::int64_t{2}},
                                       {"gain", 6.0},
                                       {"gian", 1.0},
                                       {"rate", 20.0},
                                       {"body.radius", 1.0},
                                       {"weights", "light"},
                                       {"gain", ParameterValue()}};
  const auto response = client.call<SetParameters>("set_parameters", with<SetParameters::Request>(bad));
  EXPECT_THAT(
      reasons(response),
      ElementsAre("gain expects a double, got an integer: write 2.0",
                  "gain = 6.0: must be between 0 and 5 1/s", "unknown parameter 'gian'; did you mean 'gain'?",
                  "rate" + kFixed, "body.radius is read-only: components share it; it is set in the graph",
                  "weights expects a list of doubles, got a string",
                  "gain expects a double, got nothing: a parameter cannot be deleted"));
  EXPECT_THAT(client.gains, ElementsAre(1.0, 1.0, 1.0, 1.0, 1.0));
  EXPECT_THAT(client.events, IsEmpty());
  EXPECT_THAT(client.call<SetParameters>("set_parameters", {}).results(), IsEmpty());
}

TEST(ParameterServices, ChangeAllOrNone) {
  Client client;
  const auto set = [&client](const std::vector<NamedValue>& parameters) {
    return client
        .call<SetParametersAtomically>("set_parameters_atomically",
                                       with<SetParametersAtomically::Request>(parameters))
        .result();
  };
  const auto refused = set({{"gain", 2.0}, {"rate", 20.0}});
  EXPECT_FALSE(refused.successful());
  EXPECT_EQ(refused.reason(), "rate" + kFixed);
  EXPECT_THAT(client.gains, ElementsAre(1.0, 1.0, 1.0, 1.0, 1.0));
  EXPECT_TRUE(set({{"gain", 2.0}, {"weights", std::vector<double>{}}}).successful());
  EXPECT_THAT(client.gains, ElementsAre(1.0, 1.0, 2.0, 2.0, 2.0));
  ASSERT_EQ(client.events.size(), 1U);
  EXPECT_EQ(client.events[0].changed_parameters().size(), 2U);
}

TEST(ParameterServices, LeaveTheRunAsItIsWhenTheyOnlyTell) {
  Client client;
  client.run(nullptr);
  const std::string alone = client.hash;
  client.call<GetParameters>("get_parameters", named<GetParameters::Request>(kNames));
  EXPECT_EQ(client.hash, alone);
  client.call<SetParameters>("set_parameters", with<SetParameters::Request>({{"gain", 9.0}}));
  EXPECT_EQ(client.hash, alone);
  client.call<SetParameters>("set_parameters", with<SetParameters::Request>({{"gain", 2.0}}));
  EXPECT_NE(client.hash, alone);
}

// A component that takes 20 ms for what it does takes none to answer: a request waits for it, no more. 499
// requests, all but the last 20 ms of them answered by the end.
TEST(ParameterServices, CostABusyComponentNoLatency) {
  Client client;
  client.latency = Duration::milliseconds(20);
  int answers = 0;
  client.run([&answers](bw::Setup& setup) {
    setup.every(
        Duration::milliseconds(1), "ask",
        [&answers, get = setup.client<GetParameters>("/robot1/publisher/get_parameters")](const Tick&) {
          get.call(named<GetParameters::Request>({"gain"}), Duration::milliseconds(30),
                   [&answers](const auto* response, const Tick&) { answers += response != nullptr ? 1 : 0; });
        });
  });
  EXPECT_GE(answers, 479);
  EXPECT_EQ(client.gains.size(), 4U);  // what is due at 500 ms comes 20 ms later
}

// A thousand changes a second: 499 calls from 1 to 499 ms, the n-th to n / 100; each is answered, each change
// is told, and the component publishes at its own pace what holds then.
TEST(ParameterServices, AnswerEveryOneOfManyChanges) {
  Client client;
  int answers = 0;
  client.run([&answers](bw::Setup& setup) {
    setup.every(
        Duration::milliseconds(1), "change",
        [&answers, set = setup.client<SetParameters>("/robot1/publisher/set_parameters")](const Tick& tick) {
          const double gain = static_cast<double>(tick.sequence + 1) / 100.0;
          set.call(with<SetParameters::Request>({{"gain", gain}}), Duration::milliseconds(10),
                   [&answers](const auto* response, const Tick&) {
                     if (response != nullptr && response->results().at(0).successful()) ++answers;
                   });
        });
  });
  EXPECT_GE(answers, 499);
  EXPECT_GE(client.events.size(), 498U);  // the hundredth sets what was there
  ASSERT_EQ(client.gains.size(), 5U);
  // At 100 ms the publisher comes before the client.
  EXPECT_THAT(client.gains, ElementsAre(0.99, 1.99, 2.99, 3.99, 4.99));
}

}  // namespace
}  // namespace bw
