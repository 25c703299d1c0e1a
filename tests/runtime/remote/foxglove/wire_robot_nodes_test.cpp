// The robot's side of a Foxglove server: services and parameters of the nodes of others.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>

#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/ros/service_ends.hpp"
#include "tests/runtime/remote/foxglove/wire_rig.hpp"
#include "tests/runtime/remote/foxglove/wire_thing.hpp"

namespace bw::foxglove::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(WireRobotNodes, CallsServicesInBytesAndInJson) {
  const Running robot(thing());
  Rig rig;
  const std::uint32_t id = rig.service("/robot1/turn");
  ASSERT_NE(id, 0U);
  EXPECT_EQ(rig.heard.services[id].type, "std_srvs/srv/SetBool");
  EXPECT_EQ(rig.heard.services[id].request.schema_name, "std_srvs/srv/SetBool_Request");
  EXPECT_THAT(rig.heard.services[id].response.schema, HasSubstr("bool success"));

  std::vector<std::variant<Bytes, std::string>> answers;
  const auto keep = [&](const auto& answer) { answers.push_back(answer); };
  SetBool::Request on;
  on.data(true);
  rig.robot->call(id, bytes_of(on), keep);
  EXPECT_TRUE(answers.empty()) << "a call does not wait";
  ASSERT_TRUE(rig.until([&] { return answers.size() == 1; }));
  SetBool::Response response;
  ASSERT_TRUE(std::holds_alternative<Bytes>(answers[0])) << std::get<std::string>(answers[0]);
  ASSERT_TRUE(deserialize(std::get<Bytes>(answers[0]), response));
  EXPECT_TRUE(response.success());
  EXPECT_EQ(response.message(), "on");

  rig.robot->call_json(id, R"({"data": false})", keep);
  ASSERT_TRUE(rig.until([&] { return answers.size() == 2; }));
  const Bytes& json = std::get<Bytes>(answers[1]);
  EXPECT_EQ(std::string(json.begin(), json.end()), R"({"success":false,"message":"off"})");

  rig.robot->call(id, Bytes{0, 1}, keep);
  rig.robot->call_json(id, "{", keep);
  rig.robot->call(99999, bytes_of(on), keep);
  ASSERT_TRUE(rig.until([&] { return answers.size() == 5; }));
  for (std::size_t i = 2; i < 5; ++i) EXPECT_TRUE(std::holds_alternative<std::string>(answers[i])) << i;
}

TEST(WireRobotNodes, ACallOfAServerThatGoesIsAnswered) {
  dds::Participant other{{.network = network()}};
  const auto ends = [&](const std::string& topic, auto traits) -> dds::EndpointOptions {
    using M = typename decltype(traits)::type;
    return {.topic = topic,
            .type = std::string(MessageTraits<M>::dds_name),
            .qos = Qos::standard(),
            .user_data = {}};
  };
  auto requests =
      other.create_reader(ends(request_topic("/silent"), std::type_identity<SetBool::Request>{}), [] {});
  auto replies = other.create_writer(ends(reply_topic("/silent"), std::type_identity<SetBool::Response>{}));
  Rig rig;
  const std::uint32_t id = rig.service("/silent");
  std::optional<std::variant<Bytes, std::string>> answer;
  rig.robot->call_json(id, "{}", [&](const auto& one) { answer = one; });
  dds::Sample sample;
  ASSERT_TRUE(rig.until([&] { return requests->take(sample); })) << "the request arrived";
  requests.reset();
  ASSERT_TRUE(rig.until([&] { return answer.has_value(); }));
  EXPECT_EQ(std::get<std::string>(*answer), "/silent is gone");
  EXPECT_EQ(rig.heard.service("/silent"), nullptr);
}

/// Parameters as they were told, once they have been.
struct Told {
  std::optional<std::vector<NamedValue>> values;
  std::vector<std::string> errors;
  Robot::Values take() {
    return [this](const std::vector<NamedValue>& v, const std::vector<std::string>& e) {
      values = v;
      errors = e;
    };
  }
  std::optional<ParameterValue> at(const std::string& name) const {
    for (const NamedValue& one : values.value_or(std::vector<NamedValue>{})) {
      if (one.name == name) return one.value;
    }
    return std::nullopt;
  }
};

TEST(WireRobotNodes, ParametersAreReadSetAndReadBackByTheirService) {
  const Running robot(thing());
  Rig rig;
  ASSERT_NE(rig.service("/robot1/thing/list_parameters"), 0U);
  ASSERT_NE(rig.service("/robot1/thing/get_parameters"), 0U);
  ASSERT_NE(rig.service("/robot1/thing/set_parameters"), 0U);
  Told all;
  rig.robot->get_parameters({}, all.take());
  ASSERT_TRUE(rig.until([&] { return all.values.has_value(); }));
  EXPECT_EQ(all.at("/robot1/thing.gain"), ParameterValue(1.0));
  EXPECT_EQ(all.at("/robot1/thing.count"), ParameterValue(std::int64_t{3}));

  // As JSON has it, 2 is an integer: the parameter is none.
  Told set;
  rig.robot->set_parameters({{"/robot1/thing.gain", std::int64_t{2}},
                             {"/robot1/thing.count", std::int64_t{4}},
                             {"/nobody.gain", 1.0},
                             {"gain", 1.0}},
                            set.take());
  ASSERT_TRUE(rig.until([&] { return set.values.has_value(); }));
  EXPECT_EQ(set.at("/robot1/thing.gain"), ParameterValue(2.0));
  EXPECT_EQ(set.at("/robot1/thing.count"), ParameterValue(std::int64_t{3})) << "it is fixed: this holds";
  ASSERT_EQ(set.errors.size(), 3U);
  EXPECT_THAT(set.errors, testing::Contains(HasSubstr("/robot1/thing.count: ")));
  EXPECT_THAT(set.errors, testing::Contains(HasSubstr("/nobody: there is no such node")));
  ASSERT_TRUE(rig.until([&] { return !rig.heard.parameters.empty(); }));
  EXPECT_THAT(rig.heard.parameters, ElementsAre(NamedValue{"/robot1/thing.gain", 2.0}));

  using rcl_interfaces::srv::GetParameters;
  dds::Participant other{{.network = network()}};
  GetParameters::Request request;
  request.names({"gain"});
  const auto asked =
      call_service<GetParameters>(other, "/robot1/thing/get_parameters", request, std::chrono::seconds(10));
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->values().at(0).double_value(), 2.0);
}

// Nobody asks the node again: a change of another program comes by /parameter_events.
TEST(WireRobotNodes, KnowsWhatOthersChange) {
  const Running robot(thing());
  Rig rig;
  ASSERT_NE(rig.service("/robot1/thing/list_parameters"), 0U);
  ASSERT_NE(rig.service("/robot1/thing/get_parameters"), 0U);
  Told before;
  rig.robot->get_parameters({"/robot1/thing.gain"}, before.take());
  ASSERT_TRUE(rig.until([&] { return before.values.has_value(); }));
  Rig another;
  ASSERT_NE(another.service("/robot1/thing/set_parameters"), 0U);
  ASSERT_NE(another.service("/robot1/thing/list_parameters"), 0U);
  ASSERT_NE(another.service("/robot1/thing/get_parameters"), 0U);
  Told set;
  another.robot->set_parameters({{"/robot1/thing.gain", 3.5}}, set.take());
  ASSERT_TRUE(another.until([&] { return set.values.has_value(); }));
  ASSERT_TRUE(rig.until([&] { return !rig.heard.parameters.empty(); }));
  Told after;
  rig.robot->get_parameters({"/robot1/thing.gain", "/robot1/thing.none"}, after.take());
  ASSERT_TRUE(after.values.has_value()) << "known: answered at once";
  EXPECT_EQ(after.at("/robot1/thing.gain"), ParameterValue(3.5));
  EXPECT_THAT(after.errors, ElementsAre("/robot1/thing.none: nobody has a parameter of this name"));
}

}  // namespace
}  // namespace bw::foxglove::test
