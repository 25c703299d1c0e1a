// Parameters: asked, set, heard of.
#include <string>
#include <vector>

#include "tests/runtime/remote/foxglove/rig.hpp"

namespace bw::foxglove::test {
namespace {

class Parameters : public Rig {
 protected:
  void get(ConnectionId id, const json& names, const std::string& request) {
    text(id, {{"op", "getParameters"}, {"parameterNames", names}, {"id", request}});
  }
};

TEST_F(Parameters, AreAskedForByNameOrAll) {
  opened(1);
  get(1, {"/a.b", "/a.c"}, "r1");
  ASSERT_EQ(robot_.gets.size(), 1U);
  EXPECT_EQ(robot_.gets[0].names, (std::vector<std::string>{"/a.b", "/a.c"}));
  robot_.gets[0].values({{"/a.b", 2.0}}, {"/a.c: no such parameter"});
  const std::vector<json> ops = texts(1);
  ASSERT_EQ(ops.size(), 2U);
  EXPECT_EQ(ops[0], json::parse(R"({"op": "status", "level": 2, "message": "/a.c: no such parameter"})"));
  EXPECT_EQ(ops[1], json::parse(R"({"op": "parameterValues", "id": "r1",
    "parameters": [{"name": "/a.b", "value": 2.0, "type": "float64"}]})"));
  get(1, json::array(), "get-all-params");
  EXPECT_TRUE(robot_.gets[1].names.empty());
}

TEST_F(Parameters, AreSetAndWhatHoldsIsTold) {
  opened(1);
  const json change = {{{"name", "/a.b"}, {"value", 0.5}}};
  text(1, {{"op", "setParameters"}, {"parameters", change}, {"id", "s"}});
  ASSERT_EQ(robot_.sets.size(), 1U);
  EXPECT_EQ(robot_.sets[0].parameters, (std::vector<NamedValue>{{"/a.b", 0.5}}));
  sender_.take(1);
  robot_.sets[0].values({{"/a.b", 0.4}}, {"/a.b: must be at most 0.4"});
  const std::vector<json> ops = texts(1);
  ASSERT_EQ(ops.size(), 2U);
  EXPECT_EQ(ops[0].at("message"), "/a.b: must be at most 0.4");
  EXPECT_EQ(ops[1].at("parameters").at(0).at("value"), 0.4);
  EXPECT_EQ(ops[1].at("id"), "s");

  text(1, {{"op", "setParameters"}, {"parameters", change}});  // without id nothing is asked for
  robot_.sets[1].values({{"/a.b", 0.5}}, {});
  EXPECT_TRUE(texts(1).empty());
}

TEST_F(Parameters, ThirtyTwoRequestsAreInFlightAtMost) {
  opened(1);
  for (int i = 0; i < 32; ++i) get(1, {"/a.b"}, "r");
  EXPECT_TRUE(texts(1).empty());
  get(1, {"/a.b"}, "r");
  expect_status(1, 2, "32 requests for parameters are in flight already");
  robot_.gets[0].values({}, {});
  sender_.take(1);
  get(1, {"/a.b"}, "r");
  EXPECT_TRUE(texts(1).empty());
  EXPECT_EQ(robot_.gets.size(), 33U);
}

TEST_F(Parameters, ChangesReachThoseWhoAskedForThem) {
  for (const ConnectionId id : {1, 2, 3}) opened(id);
  const auto interest = [this](ConnectionId id, const char* op, const json& names) {
    text(id, {{"op", op}, {"parameterNames", names}});
  };
  const auto heard = [this](ConnectionId id) {
    std::vector<std::string> names;
    for (const json& op : texts(id)) {
      for (const json& parameter : op.at("parameters")) names.push_back(parameter.at("name"));
    }
    return names;
  };
  const std::vector<NamedValue> changes = {{"/a.b", true}, {"/a.c", std::int64_t{1}}};
  interest(1, "subscribeParameterUpdates", {"/a.b"});
  interest(1, "subscribeParameterUpdates", {"/a.b", "/a.d"});  // accumulates
  interest(2, "subscribeParameterUpdates", json::array());     // all
  server_->on_parameters(changes);
  EXPECT_EQ(heard(1), std::vector<std::string>{"/a.b"});
  EXPECT_EQ(heard(2), (std::vector<std::string>{"/a.b", "/a.c"}));
  EXPECT_TRUE(heard(3).empty());
  interest(2, "unsubscribeParameterUpdates", {"/a.b"});  // all but that one
  interest(1, "unsubscribeParameterUpdates", {"/a.b"});
  server_->on_parameters(changes);
  EXPECT_TRUE(heard(1).empty());
  EXPECT_EQ(heard(2), std::vector<std::string>{"/a.c"});
  interest(2, "unsubscribeParameterUpdates", json::array());
  server_->on_parameters(changes);
  EXPECT_TRUE(heard(2).empty());
  interest(2, "subscribeParameterUpdates", {"/a.b"});
  server_->on_parameters({{"/a.b", {}}});  // deleted: no value
  EXPECT_EQ(only_text(2).at("parameters"), json::parse(R"([{"name": "/a.b"}])"));
}

TEST_F(Parameters, NamesThatAreKeptAreBounded) {
  opened(1);
  json names = json::array();
  for (std::size_t i = 0; i <= ParameterInterest::kMaxNames; ++i) names.push_back("/n" + std::to_string(i));
  text(1, {{"op", "subscribeParameterUpdates"}, {"parameterNames", names}});
  expect_status(1, 2, "more than 20000 names");
  text(1, {{"op", "unsubscribeParameterUpdates"}, {"parameterNames", names}});
  EXPECT_TRUE(texts(1).empty());
}

TEST_F(Parameters, AnswersToThoseWhoLeftAreDropped) {
  opened(1);
  get(1, {"/a.b"}, "r");
  server_->on_close(1);
  robot_.gets[0].values({{"/a.b", true}}, {"late"});
  EXPECT_TRUE(texts(1).empty());
  opened(2);
  get(2, {"/a.b"}, "r");
  server_.reset();
  robot_.gets[1].values({{"/a.b", true}}, {});
  EXPECT_TRUE(texts(2).empty());
}

TEST_F(Parameters, WhoMayNotCommandHearsWhyAndWhatHolds) {
  opened(1, false);
  text(1, {{"op", "setParameters"}, {"parameters", {{{"name", "/a.b"}, {"value", true}}}}, {"id", "s"}});
  expect_status(1, 2, "setParameters: read only: commands need a token");
  EXPECT_TRUE(robot_.sets.empty());
  ASSERT_EQ(robot_.gets.size(), 1U);
  EXPECT_EQ(robot_.gets[0].names, std::vector<std::string>{"/a.b"});
  robot_.gets[0].values({{"/a.b", false}}, {});
  EXPECT_EQ(only_text(1),
            json::parse(
                R"({"op": "parameterValues", "id": "s", "parameters": [{"name": "/a.b", "value": false}]})"));
}

}  // namespace
}  // namespace bw::foxglove::test
