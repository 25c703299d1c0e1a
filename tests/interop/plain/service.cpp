#include "tests/interop/plain/service.hpp"

#include <condition_variable>

#include "tests/interop/eventually.hpp"

namespace plain {
namespace {

/// std_srvs/srv/Trigger, "_Request_" -> std_srvs::srv::dds_::Trigger_Request_
std::string dds_name(const std::string& type, const std::string& suffix) {
  const std::size_t first = type.find('/'), second = type.rfind('/');
  return type.substr(0, first) + "::" + type.substr(first + 1, second - first - 1) +
         "::dds_::" + type.substr(second + 1) + suffix;
}

std::int64_t number(const rtps::SequenceNumber_t& sequence) {
  return static_cast<std::int64_t>(sequence.to64long());
}

}  // namespace

std::string request_topic(const std::string& service) { return "rq" + service + "Request"; }
std::string reply_topic(const std::string& service) { return "rr" + service + "Reply"; }
std::string request_type(const std::string& type) { return dds_name(type, "_Request_"); }
std::string response_type(const std::string& type) { return dds_name(type, "_Response_"); }

Client::Client(Node& node, const std::string& service, const ServiceType& type, Identity identity, int depth)
    : node_(node),
      service_(service),
      identity_(identity),
      reader_(
          node.create_reader({reply_topic(service), response_type(type.name), type.response_hash, depth})),
      writer_(
          node.create_writer({request_topic(service), request_type(type.name), type.request_hash, depth})) {
  node_.announce();
}

Client::~Client() {
  node_.remove(reader_);
  node_.remove(writer_);
}

bool Client::is_ready() const {
  const int servers = node_.count(request_topic(service_), false);
  if (servers == 0 || servers != node_.count(reply_topic(service_), true)) return false;
  dds::PublicationMatchedStatus readers;
  writer_->get_publication_matched_status(readers);
  dds::SubscriptionMatchedStatus writers;
  reader_->get_subscription_matched_status(writers);
  return readers.current_count > 0 && readers.current_count == writers.current_count;
}

std::int64_t Client::send(const Bytes& request) {
  rtps::WriteParams params;
  if (identity_ == Identity::reply_reader) params.related_sample_identity().writer_guid(reader_->guid());
  if (identity_ == Identity::request_writer) params.related_sample_identity().writer_guid(writer_->guid());
  Bytes bytes = request;
  if (!bw::fast_dds::write(*writer_, &bytes, params)) throw std::runtime_error("the request was not written");
  return number(params.sample_identity().sequence_number());
}

std::optional<Bytes> Client::take(std::int64_t sequence) {
  Bytes bytes;
  dds::SampleInfo info;
  while (bw::fast_dds::is_ok(reader_->take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    const rtps::SampleIdentity& to = info.related_sample_identity;
    if (to.writer_guid() == reader_->guid() || to.writer_guid() == writer_->guid()) {
      replies_[number(to.sequence_number())] = bytes;
    } else {
      ++foreign_replies_;
    }
  }
  const auto found = replies_.find(sequence);
  if (found == replies_.end()) return std::nullopt;
  Bytes reply = std::move(found->second);
  replies_.erase(found);
  return reply;
}

std::optional<Bytes> Client::call(const Bytes& request, std::chrono::milliseconds limit) {
  constexpr std::chrono::milliseconds kPause{2};
  std::optional<std::int64_t> asked;
  std::optional<Bytes> reply;
  bw::test::poll_until(std::chrono::steady_clock::now() + limit, kPause, [&] {
    if (!asked && is_ready()) asked = send(request);
    if (asked) reply = take(*asked);
    return reply.has_value();
  });
  return reply;
}

/// Which readers the reply writer is connected to.
class Server::Matches final : public dds::DataWriterListener {
 public:
  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
    const rtps::GUID_t reader = rtps::iHandle2GUID(status.last_subscription_handle);
    const std::lock_guard lock(mutex_);
    if (status.current_count_change > 0) {
      readers_.insert(reader);
    } else {
      readers_.erase(reader);
    }
    changed_.notify_all();
  }
  bool wait(const rtps::GUID_t& reader, std::chrono::milliseconds limit) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, limit, [&] { return readers_.contains(reader); });
  }
  int count() {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(readers_.size());
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<rtps::GUID_t> readers_;
};

Server::Server(Node& node, const std::string& service, const ServiceType& type, bool without_reply_writer)
    : node_(node),
      reply_end_{reply_topic(service), response_type(type.name), type.response_hash},
      matches_(std::make_unique<Matches>()) {
  if (!without_reply_writer) complete();
  reader_ = node.create_reader({request_topic(service), request_type(type.name), type.request_hash});
  node_.announce();
}

Server::~Server() {
  node_.remove(reader_);
  if (writer_ != nullptr) node_.remove(writer_);
}

void Server::complete() {
  writer_ = node_.create_writer(reply_end_, matches_.get());
  node_.announce();
}

std::optional<Request> Server::take() {
  Bytes bytes;
  dds::SampleInfo info;
  while (bw::fast_dds::is_ok(reader_->take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    Request request{.from = info.sample_identity,
                    .related = info.related_sample_identity.writer_guid(),
                    .writer = info.sample_identity.writer_guid(),
                    .bytes = bytes};
    if (request.related != rtps::c_Guid_Unknown) request.from.writer_guid(request.related);
    return request;
  }
  return std::nullopt;
}

bool Server::reply(const rtps::SampleIdentity& to, const Bytes& response) {
  const bool is_reader = (to.writer_guid().entityId.value[3] & 0x0fU) == 0x04U ||
                         (to.writer_guid().entityId.value[3] & 0x0fU) == 0x07U;
  if (is_reader && !matches_->wait(to.writer_guid(), std::chrono::milliseconds(100))) return false;
  rtps::WriteParams params;
  params.related_sample_identity(to);
  Bytes bytes = response;
  return bw::fast_dds::write(*writer_, &bytes, params);
}

int Server::connected_clients() { return matches_->count(); }

int Server::connected_writers() const {
  dds::SubscriptionMatchedStatus writers;
  reader_->get_subscription_matched_status(writers);
  return writers.current_count;
}

}  // namespace plain
