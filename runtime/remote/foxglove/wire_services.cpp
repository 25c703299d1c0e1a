#include "runtime/remote/foxglove/wire_services.hpp"

#include <algorithm>
#include <stdexcept>

#include "runtime/recording/bag/schema.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::foxglove {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds kDeadline{10};
constexpr std::chrono::hours kGoalDeadline{1};   // a result comes when the goal ends
constexpr std::chrono::seconds kCallLinger{10};  // ends of a client that nobody uses
constexpr std::string_view kRequest = "_Request";

MessageType names_of(const TypeDescription& type) { return {type.ros_name, type.dds_name, type.type_hash}; }

}  // namespace

WireServices::WireServices(WireLink& link) : link_(link), hearing_(link.post, [this] { hear(); }) {}

void WireServices::look(const std::vector<dds::Endpoint>& endpoints) {
  std::map<std::string, std::set<dds::Guid>> servers;
  std::vector<Service> added;
  for (const dds::Endpoint& e : endpoints) {
    const std::string name = service_of_request(e.topic);
    if (name.empty() || e.is_writer) continue;
    servers[name].insert(e.guid);
    if (id_of_.contains(name)) continue;
    const std::optional<Offer> offer = offer_of(name, e, endpoints);
    if (!offer) continue;
    id_of_[name] = offer->service.id;
    offers_[offer->service.id] = *offer;
    added.push_back(offer->service);
  }
  std::vector<std::uint32_t> removed;
  std::vector<Answer> answers;
  for (auto& [id, offer] : offers_) {
    offer.servers = servers[offer.service.name];
    if (!offer.servers.empty()) continue;
    removed.push_back(id);
    id_of_.erase(offer.service.name);
    const auto caller = callers_.find(id);
    if (caller == callers_.end()) continue;
    for (Call& call : caller->second.calls)
      answers.emplace_back(std::move(call.on_reply), offer.service.name + " is gone");
    callers_.erase(caller);
  }
  for (const std::uint32_t id : removed) offers_.erase(id);
  if (link_.listener != nullptr && (!added.empty() || !removed.empty()))
    link_.listener->on_services(added, removed);
  give(std::move(answers));
}

/// Nothing for a type that is not known, which is said once.
std::optional<WireServices::Offer> WireServices::offer_of(const std::string& name,
                                                          const dds::Endpoint& server,
                                                          const std::vector<dds::Endpoint>& endpoints) {
  const std::string asked = ros_type(server.type);
  if (!asked.ends_with(kRequest)) return std::nullopt;
  const std::string type = asked.substr(0, asked.size() - kRequest.size());
  std::string response_hash;
  for (const dds::Endpoint& e : endpoints) {
    if (e.is_writer && e.topic == reply_topic(name)) response_hash = type_hash_in(e.user_data);
  }
  const TypeDescription* request = find_type(asked, type_hash_in(server.user_data));
  const TypeDescription* response = find_type(type + "_Response", response_hash);
  if (request == nullptr || response == nullptr) {
    if (told_.insert(type).second)
      link_.say(0, name + " (" + type + ") is not shown: this program does not know the type");
    return std::nullopt;
  }
  const auto schema_of = [this](const TypeDescription& one) -> ServiceSchema {
    auto [text, is_new] = schemas_.try_emplace(&one);
    if (is_new) text->second = bag::schema_text(one);
    return {.schema_name = std::string(one.ros_name), .schema = text->second};
  };
  const auto next = static_cast<std::uint32_t>(ids_.size() + 1);
  const std::uint32_t id = ids_.emplace(std::pair(name, request), next).first->second;
  return Offer{.service = {.id = id,
                           .name = name,
                           .type = type,
                           .request = schema_of(*request),
                           .response = schema_of(*response)},
               .request = request,
               .response = response,
               .servers = {}};
}

std::vector<Service> WireServices::services() const {
  std::vector<Service> all;
  for (const auto& [id, offer] : offers_) all.push_back(offer.service);
  return all;
}

const WireServices::Offer* WireServices::find(std::uint32_t service) const {
  const auto found = offers_.find(service);
  return found == offers_.end() ? nullptr : &found->second;
}

const WireServices::Offer* WireServices::find(const std::string& name) const {
  const auto found = id_of_.find(name);
  return found == id_of_.end() ? nullptr : find(found->second);
}

void WireServices::call(std::uint32_t service, std::span<const std::uint8_t> request, OnReply on_reply) {
  const Offer* offer = find(service);
  if (offer == nullptr) return answer_later(std::move(on_reply), "nobody offers this service any more");
  std::string broken;
  if (!validate(*offer->request, request, &broken))
    return answer_later(std::move(on_reply), "no " + offer->service.request.schema_name + ": " + broken);
  try {
    Caller& caller = caller_of(*offer);
    const bool waits_for_goal = offer->service.name.ends_with("/_action/get_result");
    caller.used = steady_clock::now();
    caller.calls.push_back(
        {.request = {request.begin(), request.end()},
         .on_reply = std::move(on_reply),
         .deadline = caller.used + (waits_for_goal ? std::chrono::seconds(kGoalDeadline) : kDeadline),
         .sent = std::nullopt});
    hearing_.ring();
  } catch (const std::runtime_error& error) {
    answer_later(std::move(on_reply), error.what());
  }
}

WireServices::Caller& WireServices::caller_of(const Offer& offer) {
  const auto known = callers_.find(offer.service.id);
  if (known != callers_.end()) return known->second;
  Caller caller{
      .service = offer.service.name, .response = offer.response, .ends = {}, .calls = {}, .used = {}};
  caller.ends = std::make_unique<ServiceCaller>(link_.participant, offer.service.name,
                                                ServiceType{.ros_name = offer.service.type,
                                                            .request = names_of(*offer.request),
                                                            .response = names_of(*offer.response),
                                                            .event = {}},
                                                hearing_.bell());
  return callers_.emplace(offer.service.id, std::move(caller)).first->second;
}

/// Sends what can be sent by now, and takes the replies that came.
void WireServices::hear() {
  std::vector<Answer> answers = std::exchange(refused_, {});
  for (auto& [id, caller] : callers_) {
    for (Call& call : caller.calls) {
      if (!call.sent && caller.ends->is_ready()) call.sent = caller.ends->send(call.request);
      if (!call.sent) continue;
      auto reply = caller.ends->take(*call.sent);
      if (!reply) continue;
      const auto size = message_size(*caller.response, *reply);
      if (size) {
        reply->resize(*size);  // DDS pads
        answers.emplace_back(std::exchange(call.on_reply, nullptr), std::move(*reply));
      } else {
        answers.emplace_back(
            std::exchange(call.on_reply, nullptr),
            "the reply of " + caller.service + " is no " + std::string(caller.response->ros_name));
      }
    }
    std::erase_if(caller.calls, [](const Call& call) { return !call.on_reply; });
  }
  give(std::move(answers));
}

void WireServices::tick(steady_clock::time_point now) {
  std::vector<Answer> answers;
  for (auto& [id, caller] : callers_) {
    if (!caller.calls.empty()) caller.used = now;
    for (Call& call : caller.calls) {
      if (now < call.deadline) continue;
      answers.emplace_back(std::exchange(call.on_reply, nullptr), caller.service + " did not answer in time");
    }
    std::erase_if(caller.calls, [](const Call& call) { return !call.on_reply; });
  }
  std::erase_if(callers_, [&](const auto& item) {
    return item.second.calls.empty() && now - item.second.used > kCallLinger;
  });
  give(std::move(answers));
}

/// Whoever gets one may call again.
void WireServices::give(std::vector<Answer> answers) {
  for (const auto& [on_reply, answer] : answers) on_reply(answer);
}

void WireServices::answer_later(OnReply on_reply, std::string error) {
  refused_.emplace_back(std::move(on_reply), std::move(error));
  hearing_.ring();
}

}  // namespace bw::foxglove
