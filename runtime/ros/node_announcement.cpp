#include "runtime/ros/node_announcement.hpp"

#include <cstdlib>
#include <string_view>

namespace bw {

GidFormat gid_format_of_environment() {
  const char* distro = std::getenv("ROS_DISTRO");
  return distro != nullptr && std::string_view(distro) == "humble" ? GidFormat::humble
                                                                   : GidFormat::iron_and_later;
}

NodeAnnouncement::NodeAnnouncement(dds::Participant& participant, const std::string& name)
    : format_(gid_format_of_environment()),
      entities_{.participant = participant.guid(),
                .nodes = {{.node_namespace = "/", .name = name, .readers = {}, .writers = {}}}},
      writer_(participant.create_writer({.topic = kDiscoveryTopic,
                                         .type = kDiscoveryType,
                                         .qos = Qos::latched(),
                                         .user_data = {},
                                         .heartbeat = Duration::milliseconds(100)})) {}

void NodeAnnouncement::add(const dds::Reader& reader) {
  entities_.nodes.front().readers.push_back(reader.guid());
}

void NodeAnnouncement::add(const dds::Writer& writer) {
  entities_.nodes.front().writers.push_back(writer.guid());
}

void NodeAnnouncement::publish() { writer_->write(encode(entities_, format_)); }

}  // namespace bw
