// `bandwagon service list` and `call` against a process with services.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/interop/service_process.hpp"

namespace bw::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ServiceVerb : public testing::Test {
 protected:
  static void SetUpTestSuite() { server_ = std::make_unique<ServiceProcess>("serve"); }
  static void TearDownTestSuite() {
    EXPECT_EQ(server_->stop(), 0) << server_->process().err();
    server_.reset();
  }
  static Outcome service(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {BANDWAGON_PROGRAM, "service"});
    return run_to_end(arguments, std::chrono::seconds(60));
  }
  static std::unique_ptr<ServiceProcess> server_;
};

std::unique_ptr<ServiceProcess> ServiceVerb::server_;

TEST_F(ServiceVerb, ListNamesOneALine) {
  const Outcome list = service({"list"});
  EXPECT_EQ(list.status, 0) << list.err;
  for (const char* line : {"/count\n", "/example/get_state\n", "/example/trigger\n", "/switch\n"})
    EXPECT_THAT(list.out, HasSubstr(line));
}

TEST_F(ServiceVerb, ListTellsTypes) {
  EXPECT_THAT(service({"list", "-t"}).out,
              AllOf(HasSubstr("/switch [std_srvs/srv/SetBool]\n"),
                    HasSubstr("/example/set_parameters [rcl_interfaces/srv/SetParameters]\n")));
  const auto json = nlohmann::json::parse(service({"list", "--json"}).out);
  EXPECT_EQ(json.at("/count"), "std_srvs/srv/Trigger");
}

TEST_F(ServiceVerb, CallPrintsTheReplyAsYaml) {
  const Outcome call = service({"call", "/example/trigger"});
  EXPECT_EQ(call.status, 0) << call.err;
  EXPECT_EQ(call.out, "success: true\nmessage: asked\n");
}

TEST_F(ServiceVerb, CallTakesTypeAndRequestInTheOrderOfRos2) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"call", "/switch", "std_srvs/srv/SetBool", "{data: true}"},
        std::vector<std::string>{"call", "/switch", "{data: true}"},
        std::vector<std::string>{"call", "/switch", "std_srvs/srv/SetBool", R"({"data": true})"}}) {
    const Outcome call = service(arguments);
    EXPECT_EQ(call.status, 0) << call.err;
    EXPECT_EQ(call.out, "success: true\nmessage: 'on'\n");
  }
  EXPECT_EQ(service({"call", "/switch"}).out, "success: true\nmessage: 'off'\n")
      << "what is not given is false";
}

TEST_F(ServiceVerb, ARequestThatIsNoneIsWrongUse) {
  const Outcome value = service({"call", "/switch", "{data: maybe}"});
  EXPECT_EQ(value.status, 2);
  EXPECT_THAT(value.err, HasSubstr("request:1: data = maybe: must be true or false"));
  const Outcome field = service({"call", "/switch", "{dat: true}"});
  EXPECT_EQ(field.status, 2);
  EXPECT_THAT(field.err, HasSubstr("dat: unknown field; did you mean 'data'?"));
  const Outcome yaml = service({"call", "/switch", "{data: true"});
  EXPECT_EQ(yaml.status, 2);
  EXPECT_THAT(yaml.err, HasSubstr("request:"));
}

TEST_F(ServiceVerb, AnUnknownServiceIsNamedWithTheNearest) {
  const Outcome call = service({"call", "/swich"});
  EXPECT_EQ(call.status, 2);
  EXPECT_THAT(call.err, HasSubstr("/swich: unknown service; did you mean '/switch'?"));
}

TEST_F(ServiceVerb, AnotherTypeThanTheOfferedIsRefused) {
  const Outcome call = service({"call", "/switch", "std_srvs/srv/Trigger"});
  EXPECT_EQ(call.status, 2);
  EXPECT_THAT(call.err, HasSubstr("/switch is a std_srvs/srv/SetBool, not a std_srvs/srv/Trigger"));
}

TEST_F(ServiceVerb, NoReplyIsExitStatusOne) {
  const Outcome call = service({"call", "/kept", "--timeout", "0.5"});
  EXPECT_EQ(call.status, 1);
  EXPECT_THAT(call.err, HasSubstr("/kept did not answer within 0.5 s"));
}

}  // namespace
}  // namespace bw::test
