#include "runtime/ros/node_directory.hpp"

#include <algorithm>
#include <utility>

#include "runtime/ros/distro_evidence.hpp"

namespace bw {
namespace {

constexpr std::ptrdiff_t kPrefixSize = 12;  // of a participant, in the ids of its ends

}  // namespace

std::string full_name(const NodeEntities& node) {
  return (node.node_namespace == "/" ? "" : node.node_namespace) + "/" + node.name;
}

NodeDirectory::NodeDirectory(dds::Participant& participant, std::function<void()> on_news)
    : participant_(participant) {
  Qos qos = Qos::latched();
  qos.depth = 1000;  // one sample of every participant
  reader_ = participant.create_reader({.topic = kDiscoveryTopic,
                                       .type = kDiscoveryType,
                                       .qos = qos,
                                       .user_data = discovery_reader_user_data()},
                                      std::move(on_news));
}

bool NodeDirectory::update() {
  dds::Sample sample;
  bool is_new = false;
  while (reader_->take(sample)) {
    auto entities = decode_participant_entities(sample.cdr);
    // Nobody speaks for another: what one participant can have known here is one sample.
    if (!entities || !std::equal(sample.writer.begin(), sample.writer.begin() + kPrefixSize,
                                 entities->participant.begin()))
      continue;
    is_new = true;
    std::erase_if(participants_,
                  [&](const auto& known) { return known.participant == entities->participant; });
    // Names stay: a node that goes says so by a message without it, which comes before anybody has asked.
    add_names(*entities);
    participants_.push_back(std::move(*entities));
  }
  return is_new;
}

void NodeDirectory::forget_the_gone() {
  const std::vector<dds::Guid> alive = participant_.remote_participants();
  std::erase_if(participants_, [&](const ParticipantEntities& known) {
    return known.participant != participant_.guid() &&
           std::ranges::find(alive, known.participant) == alive.end();
  });
  node_of_.clear();
  for (const ParticipantEntities& participant : participants_) add_names(participant);
}

void NodeDirectory::add_names(const ParticipantEntities& participant) {
  for (const NodeEntities& node : participant.nodes) {
    for (const dds::Guid& guid : node.readers) node_of_[guid] = full_name(node);
    for (const dds::Guid& guid : node.writers) node_of_[guid] = full_name(node);
  }
}

std::string NodeDirectory::node_of(const dds::Guid& endpoint) const {
  const auto found = node_of_.find(endpoint);
  return found == node_of_.end() ? std::string() : found->second;
}

}  // namespace bw
