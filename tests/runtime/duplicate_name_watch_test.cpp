// Who else has a name of ours or serves what we serve, from nodes and endpoints as discovery shows them.
#include "runtime/host/duplicate_name_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/ros/dds_names.hpp"

namespace bw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint8_t kOurs = 1, kTheirs = 2, kOther = 3;

/// The id of an end: vendor and host are the first four octets.
dds::Guid guid(std::uint8_t participant, std::uint8_t end = 0, std::uint8_t host = 7) {
  dds::Guid id{1, 15, host, host, participant};
  id[15] = end;
  return id;
}

struct Domain {
  std::vector<ParticipantEntities> participants;
  std::vector<dds::Endpoint> endpoints;
  DuplicateNameWatch watch{
      {{.name = "/planner_server",
        .services = {"/planner_server/get_state", "/is_path_valid", "/compute_path_to_pose/_action/send_goal",
                     "/compute_path_to_pose/_action/get_result"}}}};

  void add_node(std::uint8_t participant, const std::string& name, std::uint8_t host = 7) {
    participants.push_back({.participant = guid(participant, 0xc1, host),
                            .nodes = {{.node_namespace = "/", .name = name, .readers = {}, .writers = {}}}});
  }
  void add_server(std::uint8_t participant, const std::string& service) {
    const auto end = static_cast<std::uint8_t>(endpoints.size() + 1);
    endpoints.push_back({.guid = guid(participant, end), .topic = request_topic(service)});
  }
  void add_client(std::uint8_t participant, const std::string& service) {
    add_server(participant, service);
    endpoints.back().is_writer = true;
  }
  DomainView view() const {
    return {.own_participant = guid(kOurs, 0xc1),
            .participants = participants,
            .endpoints = endpoints,
            .node_of = [](const dds::Guid& end) { return end[4] == kOther ? "/other" : ""; }};
  }
  std::vector<std::string> look() {
    std::vector<std::string> texts;
    for (const auto& news : watch.look(view())) texts.push_back(news.text);
    return texts;
  }
};

const std::string kEnd = "; end one of the two: nobody can say which is asked";

TEST(DuplicateNameWatch, ANodeOfOurNameIsToldOnceWithWhatItServes) {
  Domain domain;
  domain.add_node(kOurs, "planner_server");
  domain.add_server(kOurs, "/is_path_valid");
  domain.add_client(kTheirs, "/is_path_valid");
  domain.add_node(kTheirs, "controller_server");
  domain.add_server(kTheirs, "/follow_path/_action/send_goal");
  EXPECT_THAT(domain.look(), IsEmpty());
  EXPECT_EQ(domain.watch.rivals_of("/planner_server", domain.view()), "");

  domain.add_node(kOther, "planner_server");
  for (const char* service : {"/planner_server/get_state", "/compute_path_to_pose/_action/send_goal",
                              "/compute_path_to_pose/_action/get_result", "/is_path_valid"})
    domain.add_server(kOther, service);
  const std::string text =
      "/planner_server is there twice: a node of participant 01.0f.07.07.03.00.00.00.00.00.00.00 of this machine has the "
      "same name and serves /compute_path_to_pose, /is_path_valid too" +
      kEnd;
  EXPECT_THAT(domain.look(), IsEmpty()) << "it may not have said all of itself yet";
  EXPECT_TRUE(domain.watch.is_waiting());
  EXPECT_EQ(domain.watch.rivals_of("/planner_server", domain.view()), text) << "but it is there";
  EXPECT_THAT(domain.look(), ElementsAre(text));
  EXPECT_FALSE(domain.watch.is_waiting());
  EXPECT_THAT(domain.look(), IsEmpty());
  EXPECT_EQ(domain.watch.states().at("/planner_server").text, text);
  EXPECT_EQ(domain.watch.states().at("/planner_server").level, LogLevel::error);

  domain.participants.pop_back();
  domain.endpoints.clear();
  EXPECT_THAT(domain.look(), ElementsAre("/planner_server has no rival any more"));
  EXPECT_EQ(domain.watch.states().at("/planner_server").level, LogLevel::info);
}

TEST(DuplicateNameWatch, AServerOfOursUnderAnotherNameIsOneToo) {
  Domain domain;
  domain.add_server(kOther, "/is_path_valid");
  domain.look();
  EXPECT_THAT(domain.look(),
              ElementsAre("/is_path_valid of /planner_server is served twice: by /other of participant "
                          "01.0f.07.07.03.00.00.00.00.00.00.00 of this machine too" +
                          kEnd));
  domain.add_server(kTheirs, "/compute_path_to_pose/_action/send_goal");
  domain.look();
  EXPECT_THAT(domain.look(), ElementsAre(HasSubstr("by somebody without a node name of participant")));
}

TEST(DuplicateNameWatch, SaysWhenItIsNotOfThisMachine) {
  Domain domain;
  domain.add_node(kOther, "planner_server", 9);
  domain.look();
  EXPECT_THAT(domain.look(),
              ElementsAre(HasSubstr("01.0f.09.09.03.00.00.00.00.00.00.00 of another machine or vendor")));
}

}  // namespace
}  // namespace bw
