#include "runtime/ros/node_announcement.hpp"

#include <chrono>
#include <cstdlib>
#include <utility>

#include "runtime/ros/dds_names.hpp"

namespace bw {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(100);

std::optional<RosDistro> distro_of_environment() {
  const char* name = std::getenv("ROS_DISTRO");
  return name == nullptr ? std::nullopt : distro_named(name);
}

Duration steady_now() {
  return Duration{std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

GidFormat format_of(RosDistro distro) {
  return distro == RosDistro::humble ? GidFormat::humble : GidFormat::iron_and_later;
}

}  // namespace

NodeAnnouncement::NodeAnnouncement(dds::Participant& participant, AnnouncementOptions options)
    : participant_(participant), options_(std::move(options)), began_(steady_now()) {
  entities_.participant = participant.guid();
  std::optional<RosDistro> said =
      options_.distro == RosDistro::automatic ? distro_of_environment() : options_.distro;
  if (!said && !options_.looks_around) said = RosDistro::jazzy;
  if (said) decide(*said);
  if (!options_.looks_around || is_told_everything()) return;
  thread_ = std::thread([this] { failure_.run([this] { look_around(); }); });
}

NodeAnnouncement::NodeAnnouncement(dds::Participant& participant, const std::string& name, RosDistro distro)
    : NodeAnnouncement(participant, AnnouncementOptions{.distro = distro, .looks_around = false}) {
  add({.node_namespace = "/", .name = name, .readers = {}, .writers = {}});
}

NodeAnnouncement::~NodeAnnouncement() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void NodeAnnouncement::add(NodeEntities node) {
  const std::lock_guard lock(mutex_);
  entities_.nodes.push_back(std::move(node));
}

void NodeAnnouncement::add(const dds::Reader& reader) {
  const std::lock_guard lock(mutex_);
  entities_.nodes.back().readers.push_back(reader.guid());
}

void NodeAnnouncement::add(const dds::Writer& writer) {
  const std::lock_guard lock(mutex_);
  entities_.nodes.back().writers.push_back(writer.guid());
}

void NodeAnnouncement::remove(const dds::Reader& reader) {
  const std::lock_guard lock(mutex_);
  std::erase(entities_.nodes.back().readers, reader.guid());
}

void NodeAnnouncement::remove(const dds::Writer& writer) {
  const std::lock_guard lock(mutex_);
  std::erase(entities_.nodes.back().writers, writer.guid());
}

void NodeAnnouncement::publish() {
  const std::lock_guard lock(mutex_);
  is_published_ = true;
  write();
}

std::optional<RosDistro> NodeAnnouncement::distro() const {
  const std::lock_guard lock(mutex_);
  return decided_;
}

void NodeAnnouncement::decide(RosDistro distro) {
  const std::lock_guard lock(mutex_);
  decided_ = distro;
  // A hash on this topic is how others know the format.
  const bool is_humble = format_of(distro) == GidFormat::humble;
  writer_ = participant_.create_writer({.topic = kDiscoveryTopic,
                                        .type = kDiscoveryType,
                                        .qos = Qos::latched(),
                                        .user_data = is_humble ? "" : user_data_of(kDiscoveryTypeHash),
                                        .heartbeat = dds::kPromptHeartbeat});
  write();
}

/// With `mutex_` held.
void NodeAnnouncement::write() {
  if (writer_ && is_published_) writer_->write(encode(entities_, format_of(*decided_)));
}

void NodeAnnouncement::look_around() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      if (wake_.wait_for(lock, kPeriod, [this] { return stop_ || is_told_everything(); })) return;
    }
    if (const std::uint64_t changes = participant_.endpoint_changes(); changes != seen_changes_) {
      seen_changes_ = changes;
      evidence_ = distro_evidence(participant_.endpoints());
    }
    if (!distro()) {
      const bool is_over = steady_now() - began_ >= kPatience;
      // Bytes of Humble do no harm to later ones, as theirs do to Humble's processes.
      if (evidence_.humble || is_over) decide(evidence_.humble ? RosDistro::humble : RosDistro::jazzy);
    }
    if (options_.warn) warn_of_contradiction(evidence_);
  }
}

void NodeAnnouncement::warn_of_contradiction(const DistroEvidence& evidence) {
  const std::optional<RosDistro> ours = distro();
  if (told_contradiction_ || !ours) return;
  const bool is_humble = format_of(*ours) == GidFormat::humble;
  if (!(is_humble ? evidence.iron_and_later : evidence.humble)) return;
  told_contradiction_ = true;
  options_.warn(std::string("this domain has processes of ROS 2 ") +
                (is_humble ? "Iron or later" : "Humble or earlier") +
                ", whose tools will not list our nodes: they are " + "announced as for " +
                std::string(text_of(*ours)) + " (ros_distro); topics and services work");
}

}  // namespace bw
