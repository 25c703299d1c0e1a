// What GetTypeDescription tells of every type of this program. Expected values: each type's own hash, which
// tests/idl holds against Jazzy's generator: the description is right when REP 2011's hash of it is that one.
// Of a whole service: the hash under which rmw_zenoh of Jazzy names std_srvs/srv/Trigger on its wire.
#include "runtime/ros/type_description_messages.hpp"

#include <gmock/gmock.h>

#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

TEST(TypeDescriptionMessages, HaveTheHashOfTheTypeTheyDescribe) {
  for (const auto& types : {all_types(), other_layouts()}) {
    ASSERT_FALSE(types.empty());
    for (const TypeDescription* type : types)
      EXPECT_EQ(type_hash_of(to_message(*type)), type->type_hash) << type->ros_name;
  }
}

TEST(TypeDescriptionMessages, OfAServiceAreItsThreeParts) {
  const auto part = [](const char* name) { return to_message(*find_type(name)); };
  const auto trigger =
      join_parts("std_srvs/srv/Trigger", {{"request_message", part("std_srvs/srv/Trigger_Request")},
                                          {"response_message", part("std_srvs/srv/Trigger_Response")},
                                          {"event_message", part("std_srvs/srv/Trigger_Event")}});
  EXPECT_EQ(type_hash_of(trigger), "RIHS01_eeff2cd6fa5ad9d27cdf4dec64818317839b62f212a91e6b5304b634b2062c5f");
}

// Trigger_Event holds Trigger_Request and Trigger_Response, ServiceEventInfo and its Time.
TEST(TypeDescriptionMessages, HaveTheSourceOfEachMessageTheyName) {
  const auto sources = sources_of(to_message(*find_type("std_srvs/srv/Trigger_Event")));
  ASSERT_EQ(sources.size(), 5U);
  EXPECT_EQ(sources[0].type_name(), "std_srvs/srv/Trigger_Event");
  EXPECT_EQ(sources[0].encoding(), "implicit");
  EXPECT_EQ(sources[0].raw_file_contents(), "");
  EXPECT_EQ(sources[1].type_name(), "builtin_interfaces/msg/Time");
  EXPECT_EQ(sources[1].encoding(), "msg");
  EXPECT_EQ(sources[1].raw_file_contents(), "int32 sec\nuint32 nanosec\n");
}

}  // namespace
}  // namespace bw
