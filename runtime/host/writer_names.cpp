#include "runtime/host/writer_names.hpp"

#include <algorithm>

#include "runtime/host/actor.hpp"

namespace bw {

void WriterNames::connect(dds::Participant& participant) {
  const std::lock_guard lock(mutex_);
  participant_ = &participant;
  directory_.emplace(participant);
}

void WriterNames::disconnect() {
  const std::lock_guard lock(mutex_);
  directory_.reset();
  participant_ = nullptr;
}

const Actor* WriterNames::own(const dds::Guid& writer) const {
  const auto is_it = [&](const auto& output) { return output->writer && output->writer->guid() == writer; };
  const auto actor = std::ranges::find_if(
      actors_, [&](const auto& one) { return std::ranges::any_of(one->outputs, is_it); });
  return actor == actors_.end() ? nullptr : actor->get();
}

std::string WriterNames::node_of(const dds::Guid& writer) {
  if (const Actor* actor = own(writer))
    return full_name({.node_namespace = actor->node_namespace, .name = actor->node_name});
  const std::lock_guard lock(mutex_);
  if (!directory_) return {};
  directory_->forget_the_gone();  // before: who wrote once and left is still to be named
  directory_->update();
  return directory_->node_of(writer);
}

std::optional<Duration> WriterNames::lease_of(const dds::Guid& writer) {
  if (own(writer) != nullptr) return Duration{};
  const std::lock_guard lock(mutex_);
  return participant_ == nullptr ? std::nullopt : participant_->lease_of(writer);
}

}  // namespace bw
