#include "runtime/recording/replay/latched.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <tf2_msgs/msg/tf_message.hpp>

#include "runtime/wire/serialization.hpp"

namespace bw::replay {
namespace {

constexpr std::size_t kMany = 1000;

/// What is kept of one writer.
struct Kept {
  std::size_t order = 0;  ///< among all messages read
  Time log_time;
  bag::Bytes cdr;
};

struct OfWriter {
  std::vector<Kept> messages;
  std::size_t most = kMany;  ///< then those that are outdated go
};

std::set<std::string> frames_of(const bag::Bytes& cdr) {
  tf2_msgs::msg::TFMessage message;
  std::set<std::string> frames;
  if (!deserialize(cdr, message)) return frames;
  for (const auto& transform : message.transforms()) frames.insert(transform.child_frame_id());
  return frames;
}

/// Leaves out messages all of whose frames later ones tell again.
void forget_outdated(std::vector<Kept>& messages) {
  std::set<std::string> told;
  std::vector<Kept> needed;
  for (auto m = messages.rbegin(); m != messages.rend(); ++m) {
    bool is_needed = false;
    for (const std::string& frame : frames_of(m->cdr)) is_needed = told.insert(frame).second || is_needed;
    if (is_needed) needed.push_back(std::move(*m));
  }
  std::ranges::reverse(needed);
  messages = std::move(needed);
}

}  // namespace

std::vector<LatchedMessage> latched_before(const bag::Bag& recording, Time time,
                                           const std::vector<std::optional<PlayedTopic>>& played) {
  const auto is_latched = [&](std::size_t topic) {
    return played[topic] && played[topic]->qos.durability == Durability::transient_local;
  };
  const std::vector<bag::BagTopic>& topics = recording.topics();
  const auto is_transforms = [&](std::size_t topic) {
    return topics[topic].type == "tf2_msgs/msg/TFMessage";
  };
  std::set<std::string> names;
  for (std::size_t i = 0; i < played.size(); ++i) {
    if (is_latched(i)) names.insert(topics[i].name);
  }
  std::map<std::size_t, OfWriter> kept;
  const auto messages = recording.messages({.end = time, .topics = names});
  bag::BagMessage m;
  std::size_t count = 0;
  for (bag::Step step = messages->next(m); step != bag::Step::end; step = messages->next(m)) {
    if (step == bag::Step::damaged || !is_latched(m.topic)) continue;
    OfWriter& of_writer = kept[m.topic];
    if (!is_transforms(m.topic)) of_writer.messages.clear();
    of_writer.messages.push_back({++count, m.log_time, {m.data.begin(), m.data.end()}});
    if (of_writer.messages.size() < of_writer.most) continue;
    forget_outdated(of_writer.messages);
    of_writer.most = 2 * of_writer.messages.size() + kMany;
  }
  std::map<std::size_t, LatchedMessage> in_order;
  for (auto& [topic, of_writer] : kept) {
    if (is_transforms(topic)) forget_outdated(of_writer.messages);
    for (Kept& one : of_writer.messages) {
      const auto& lifespan = played[topic]->qos.lifespan;
      if (lifespan && time - one.log_time > *lifespan) continue;
      in_order[one.order] = {topic, std::move(one.cdr)};
    }
  }
  std::vector<LatchedMessage> out;
  for (auto& [order, message] : in_order) out.push_back(std::move(message));
  return out;
}

}  // namespace bw::replay
