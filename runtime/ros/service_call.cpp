#include "runtime/ros/service_call.hpp"

#include <utility>

#include "runtime/ros/notifier.hpp"
#include "runtime/ros/service_ends.hpp"

namespace bw {

ServiceCaller::ServiceCaller(dds::Participant& participant, const std::string& name, const ServiceType& type,
                             const std::function<void()>& on_news)
    : reader_(participant.create_reader(service_end(reply_topic(name), type.response), on_news, on_news)),
      writer_(participant.create_writer(service_end(request_topic(name), type.request), on_news)) {}

bool ServiceCaller::is_ready() const {
  return writer_->matched_readers() > 0 && reader_->matched_writers() > 0;
}

std::optional<std::int64_t> ServiceCaller::send(std::span<const std::uint8_t> request) {
  const auto asked = writer_->write_related(request, {reader_->guid(), 0});
  return asked ? std::optional(asked->sequence) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> ServiceCaller::take(std::int64_t request) {
  dds::Sample sample;
  while (reader_->take(sample)) {
    const dds::Guid& to = sample.related.guid;
    if (to == reader_->guid() || to == writer_->guid())
      replies_[sample.related.sequence] = std::move(sample.cdr);
  }
  const auto reply = replies_.extract(request);
  return reply.empty() ? std::nullopt : std::optional(std::move(reply.mapped()));
}

std::optional<std::vector<std::uint8_t>> call_service(dds::Participant& participant, const std::string& name,
                                                      const ServiceType& type,
                                                      std::span<const std::uint8_t> request,
                                                      std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  Notifier bell;
  ServiceCaller caller(participant, name, type, [&bell] { bell.ring(); });
  while (!caller.is_ready()) {
    if (!bell.wait(end)) return std::nullopt;
  }
  const auto asked = caller.send(request);
  if (!asked) return std::nullopt;
  do {
    if (auto reply = caller.take(*asked)) return reply;
  } while (bell.wait(end));
  return std::nullopt;
}

}  // namespace bw
