#include "runtime/host/outside_inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/ros/dds_names.hpp"

namespace bw {
namespace {

/// So many enter at one instant; the rest at the next.
constexpr std::size_t kMaxPerInstant = 100;

}  // namespace

/// The component that publishes what entered.
class OutsideInputs::Mouth final : public Component {
 public:
  Mouth(OutsideInputs& inputs, std::vector<Topic> topics) : inputs_(inputs), topics_(std::move(topics)) {}

  void configure(Setup& setup) override {
    for (const Topic& topic : topics_) {
      Qos qos = topic.qos;
      qos.reliability = Reliability::reliable;
      inputs_.ports_[topic.name] = setup.raw_output(topic.name, topic.type, qos);
    }
  }

 private:
  OutsideInputs& inputs_;
  std::vector<Topic> topics_;
};

std::vector<OutsideInputs::Topic> OutsideInputs::topics_of(
    const std::vector<std::unique_ptr<Actor>>& actors) {
  std::set<std::string> known;
  for (const auto& actor : actors) {
    for (const auto& output : actor->outputs) known.insert(output->topic);
  }
  std::vector<Topic> topics;
  for (const auto& actor : actors) {
    for (const auto& input : actor->inputs) {
      if (known.insert(input->topic).second) topics.push_back({input->topic, input->type, input->qos});
    }
  }
  return topics;
}

std::unique_ptr<Component> OutsideInputs::make_component(std::vector<Topic> topics) {
  return std::make_unique<Mouth>(*this, std::move(topics));
}

void OutsideInputs::connect(dds::Participant& participant, const std::vector<Topic>& topics,
                            const std::vector<Actor*>& actors) {
  for (const Topic& topic : topics) {
    if (topic.name.ends_with(kServiceEvent)) continue;
    ears_.push_back({topic.name, participant.create_reader({.topic = dds_topic(topic.name),
                                                            .type = std::string(topic.type.dds_name),
                                                            .qos = topic.qos,
                                                            .user_data = {},
                                                            .partitions = {""}},
                                                           [this] { has_news(); })});
  }
  for (Actor* actor : actors) {
    for (const auto& service : actor->services) services_.push_back(service.get());
  }
}

void OutsideInputs::look(Time now) {
  if (!has_news_.exchange(false)) return;
  for (ServiceEnd* service : services_) {
    service->flush();
    for (ServiceEnd::Request& request : service->take_foreign()) {
      if (!service->changes_something()) {
        service->answer(request, now);
      } else if (accepts_) {
        kept_.push_back({.service = service, .topic = {}, .request = std::move(request)});
      } else {
        service->refuse(request.from, kRefusal);
        tell_refusal("request to " + service->service, request.from.client);
      }
    }
  }
  for (Ear& ear : ears_) listen(ear);
}

void OutsideInputs::listen(Ear& ear) {
  dds::Sample sample;
  while (ear.reader->take(sample)) {
    if (dds::same_participant(sample.writer, ear.reader->guid())) continue;
    if (accepts_) {
      kept_.push_back({.service = nullptr, .topic = ear.topic, .request = {{}, sample.cdr}});
    } else {
      tell_refusal("message on " + ear.topic, sample.writer);
    }
  }
}

/// Once for each sender: not every reply has a place for a reason.
void OutsideInputs::tell_refusal(const std::string& what, const dds::Guid& sender) {
  if (refused_.emplace(what, sender).second) warn_(fmt::format("refused a {}: {}", what, kRefusal));
}

void OutsideInputs::enter(Time now) {
  const std::size_t count = std::min(kept_.size(), kMaxPerInstant);
  for (std::size_t i = 0; i < count; ++i) {
    Kept& kept = kept_[i];
    was_used_ = true;
    if (kept.service == nullptr) {
      ports_.at(kept.topic)->publish(kept.request.cdr);
      continue;
    }
    std::vector<std::uint8_t> event;
    if (kept.service->handler.to_event(kept.request.cdr, kept.request.from, now, event)) {
      ports_.at(kept.service->service + kServiceEvent)->publish(event);
    } else {
      kept.service->refuse(kept.request.from,
                           "the request holds no " + std::string(kept.service->type.ros_name));
    }
  }
  kept_.erase(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace bw
