#include "tests/components/viewer/foxglove_client.hpp"

#include <algorithm>
#include <cstring>
#include <regex>
#include <span>
#include <utility>

#include <poll.h>

#include "tests/interop/eventually.hpp"

namespace bw::test {
namespace {

template <class Number>
Number number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  Number value{};
  if (bytes.size() >= at + sizeof value) std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void append(std::vector<std::uint8_t>& bytes, const std::string& text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

}  // namespace

FoxgloveClient::FoxgloveClient(const PageAddress& page, bool hears_everything)
    : client_(page.port, 0, page.token), hears_everything_(hears_everything), thread_([this] { read(); }) {
  // Nothing may be said before the server has agreed to speak the protocol.
  eventually([this] { return !info().empty(); });
}

FoxgloveClient::~FoxgloveClient() {
  stop_ = true;
  thread_.join();
}

void FoxgloveClient::read() {
  const auto take = [this](bool is_text, std::span<const std::uint8_t> payload) {
    const std::lock_guard lock(mutex_);
    if (is_text) {
      take_text(nlohmann::json::parse(payload.begin(), payload.end()));
    } else {
      take_binary(payload);
    }
  };
  while (!stop_ && !is_closed_) {
    pollfd waiting{.fd = client_.descriptor(), .events = POLLIN, .revents = 0};
    ::poll(&waiting, 1, 50);
    if (!client_.receive(1 << 20, take)) is_closed_ = true;
  }
}

void FoxgloveClient::take_text(const nlohmann::json& op) {
  const std::string name = op.at("op");
  if (name == "serverInfo") info_ = op;
  if (name == "status") statuses_.push_back(op.at("message"));
  if (name == "parameterValues") {
    nlohmann::json values = nlohmann::json::object();
    for (const auto& one : op.at("parameters")) values[one.at("name")] = one.value("value", nlohmann::json());
    parameters_[op.value("id", "")] = values;
  }
  if (name == "serviceCallFailure") answers_[op.at("callId")] = {{"error", op.at("message")}};
  if (name == "advertise") {
    for (const auto& one : op.at("channels")) {
      channels_[one.at("id")] = one.at("topic");
      channel_of_[one.at("topic")] = one.at("id");
      if (hears_everything_) send_subscription(one.at("id"));
    }
  }
  if (name == "unadvertise") {
    for (const std::uint32_t id : op.at("channelIds")) channel_of_.erase(channels_[id]);
  }
  if (name == "advertiseServices") {
    for (const auto& one : op.at("services")) services_[one.at("name")] = one.at("id");
  }
}

void FoxgloveClient::take_binary(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kMessage = 1, kTime = 2, kReply = 3;
  if (bytes.empty()) return;
  if (bytes[0] == kTime) time_ = number_at<std::int64_t>(bytes, 1);
  if (bytes[0] == kMessage && bytes.size() >= 13) {
    const auto payload = bytes.subspan(13);  // the subscription has the id of its channel
    messages_[channels_[number_at<std::uint32_t>(bytes, 1)]].push_back(
        {number_at<std::int64_t>(bytes, 5), {payload.begin(), payload.end()}});
  }
  if (bytes[0] == kReply && bytes.size() >= 13) {
    const auto encoding = number_at<std::uint32_t>(bytes, 9);
    const auto payload = bytes.subspan(13 + encoding);
    answers_[number_at<std::uint32_t>(bytes, 5)] = nlohmann::json::parse(payload.begin(), payload.end());
  }
}

void FoxgloveClient::send(const nlohmann::json& op) { client_.send_text(op.dump()); }

void FoxgloveClient::send_subscription(std::uint32_t channel) {
  send({{"op", "subscribe"}, {"subscriptions", {{{"id", channel}, {"channelId", channel}}}}});
}

bool FoxgloveClient::has_channel(const std::string& topic) {
  return eventually([&] {
    const std::lock_guard lock(mutex_);
    return channel_of_.contains(topic);
  });
}

bool FoxgloveClient::subscribe(const std::string& topic) {
  if (!has_channel(topic)) return false;
  const std::lock_guard lock(mutex_);
  send_subscription(channel_of_.at(topic));
  return true;
}

bool FoxgloveClient::wait_for(const std::string& topic, std::size_t messages) {
  return eventually([&] {
    const std::lock_guard lock(mutex_);
    return messages_[topic].size() >= messages;
  });
}

bool FoxgloveClient::has_service(const std::string& service) {
  return eventually([&] {
    const std::lock_guard lock(mutex_);
    return services_.contains(service);
  });
}

nlohmann::json FoxgloveClient::call(const std::string& service, const nlohmann::json& request) {
  if (!has_service(service)) return {{"error", "it is not offered"}};
  std::uint32_t call = 0;
  {
    const std::lock_guard lock(mutex_);
    call = ++calls_;
    Bytes frame = {2};
    append(frame, services_.at(service));
    append(frame, call);
    append(frame, 4U);
    append(frame, std::string("json") + request.dump());
    client_.send_binary(frame);
  }
  nlohmann::json answer = {{"error", "no answer"}};
  eventually([&] {
    const std::lock_guard lock(mutex_);
    const auto found = answers_.find(call);
    if (found != answers_.end()) answer = found->second;
    return found != answers_.end();
  });
  return answer;
}

std::map<std::string, nlohmann::json> FoxgloveClient::set_parameter(const std::string& name,
                                                                    const nlohmann::json& value) {
  std::string id;
  {
    const std::lock_guard lock(mutex_);
    id = "set" + std::to_string(++calls_);
    send({{"op", "setParameters"}, {"id", id}, {"parameters", {{{"name", name}, {"value", value}}}}});
  }
  std::map<std::string, nlohmann::json> values;
  eventually([&] {
    const std::lock_guard lock(mutex_);
    if (!parameters_.contains(id)) return false;
    values = parameters_[id].get<std::map<std::string, nlohmann::json>>();
    return true;
  });
  return values;
}

bool FoxgloveClient::hears_status(const std::string& words) {
  return eventually([&] {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(statuses_,
                               [&](const std::string& one) { return one.find(words) != std::string::npos; });
  });
}

void FoxgloveClient::advertise(std::uint32_t id, const std::string& topic, const std::string& type) {
  const std::lock_guard lock(mutex_);
  send({{"op", "advertise"},
        {"channels", {{{"id", id}, {"topic", topic}, {"encoding", "json"}, {"schemaName", type}}}}});
}

void FoxgloveClient::publish(std::uint32_t id, const nlohmann::json& message) {
  const std::lock_guard lock(mutex_);
  Bytes frame = {1};
  append(frame, id);
  append(frame, message.dump());
  client_.send_binary(frame);
}

std::map<std::string, std::vector<FoxgloveClient::Message>> FoxgloveClient::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

std::uint32_t FoxgloveClient::channel_id(const std::string& topic) const {
  const std::lock_guard lock(mutex_);
  const auto found = channel_of_.find(topic);
  return found == channel_of_.end() ? 0 : found->second;
}

nlohmann::json FoxgloveClient::info() const {
  const std::lock_guard lock(mutex_);
  return info_;
}

double FoxgloveClient::seconds() const {
  const std::lock_guard lock(mutex_);
  return static_cast<double>(time_) * 1e-9;
}

PageAddress page_in(const std::string& words) {
  static const std::regex kAddress("http://127\\.0\\.0\\.1:([0-9]+)/(\\?token=([0-9a-f]{32}))?\n");
  std::smatch found;
  if (!std::regex_search(words, found, kAddress)) return {};
  return {static_cast<std::uint16_t>(std::stoi(found[1])), found[3]};
}

}  // namespace bw::test
