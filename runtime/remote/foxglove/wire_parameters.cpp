#include "runtime/remote/foxglove/wire_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <rcl_interfaces/msg/parameter_event.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>
#include <rcl_interfaces/srv/list_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>

#include "runtime/remote/foxglove/closest_type.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/parameter_messages.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw::foxglove {
namespace {

using rcl_interfaces::msg::ParameterEvent;
using rcl_interfaces::srv::GetParameters;
using rcl_interfaces::srv::ListParameters;
using rcl_interfaces::srv::SetParameters;

constexpr const char* kEvents = "/parameter_events";
constexpr const char* kList = "/list_parameters";
constexpr const char* kGet = "/get_parameters";
constexpr const char* kSet = "/set_parameters";

/// Node and parameter of a name; no node where there is no dot.
std::pair<std::string, std::string> parts(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return {};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

std::string unknown(const std::string& name) { return name + ": nobody has a parameter of this name"; }

}  // namespace

void WireParameters::Answer::end_one() {
  if (--open == 0) give(values, errors);
}

WireParameters::WireParameters(WireLink& link, WireServices& services)
    : link_(link),
      services_(services),
      hearing_(link.post, [this] { hear_events(); }),
      events_(link.participant.create_reader(
          {.topic = dds_topic(kEvents),
           .type = std::string(MessageTraits<ParameterEvent>::dds_name),
           .qos = Qos::standard(1000),  // as ROS 2 has it
           .user_data = user_data_of(std::string(MessageTraits<ParameterEvent>::type_hash))},
          hearing_.bell())) {
  link_.add(*events_);
}

template <class S>
void WireParameters::call(const std::string& node, const char* service, const typename S::Request& request,
                          std::function<void(const typename S::Response*, const std::string&)> then) {
  const WireServices::Offer* offer = services_.find(node + service);
  if (offer == nullptr || offer->service.type != S::ros_name) return then(nullptr, node + " is not there");
  std::vector<std::uint8_t> cdr;
  serialize(request, cdr);
  services_.call(offer->service.id, cdr, [then = std::move(then)](const auto& reply) {
    typename S::Response response;
    if (const auto* error = std::get_if<std::string>(&reply)) return then(nullptr, *error);
    if (!deserialize(std::get<Bytes>(reply), response)) return then(nullptr, "the reply cannot be read");
    then(&response, "");
  });
}

void WireParameters::look() {
  for (auto node = nodes_.begin(); node != nodes_.end();) {
    const WireServices::Offer* offer = services_.find(node->first + kList);
    const bool is_same = offer != nullptr && offer->servers == node->second.servers;
    // Who waits for one that is gone is answered by its service.
    node = is_same || !node->second.waiting.empty() ? std::next(node) : nodes_.erase(node);
  }
}

void WireParameters::know(const std::string& name, std::function<void(const std::string& error)> then) {
  const WireServices::Offer* offer = services_.find(name + kList);
  if (offer == nullptr) return then(name + ": there is no such node");
  Node& node = nodes_[name];
  if (node.is_known) return then("");
  node.servers = offer->servers;
  node.waiting.push_back(std::move(then));
  if (node.waiting.size() == 1) list(name);
}

void WireParameters::list(const std::string& node) {
  call<ListParameters>(node, kList, {},
                       [this, node](const ListParameters::Response* response, const std::string& error) {
                         if (response == nullptr) return end_knowing(node, error);
                         fetch(node, response->result().names());
                       });
}

void WireParameters::fetch(const std::string& node, const std::vector<std::string>& names) {
  GetParameters::Request request;
  request.names(names);
  call<GetParameters>(node, kGet, request,
                      [this, node, names](const GetParameters::Response* response, const std::string& error) {
                        if (response == nullptr) return end_knowing(node, error);
                        if (response->values().size() != names.size())
                          return end_knowing(node, node + " does not tell the parameters that it lists");
                        Node& known = nodes_[node];
                        for (std::size_t i = 0; i < names.size(); ++i)
                          known.values[names[i]] = from_message(response->values()[i]);
                        known.is_known = true;
                        end_knowing(node, "");
                      });
}

void WireParameters::end_knowing(const std::string& node, const std::string& error) {
  for (const auto& then : std::exchange(nodes_[node].waiting, {})) then(error);
}

void WireParameters::get(const std::vector<std::string>& names, Robot::Values values) {
  std::map<std::string, std::vector<std::string>> wanted;  // parameters by node; none: all
  const auto answer = std::make_shared<Answer>();
  answer->give = std::move(values);
  for (const std::string& name : names) {
    const auto [node, parameter] = parts(name);
    if (node.empty()) {
      answer->errors.push_back(unknown(name));
    } else {
      wanted[node].push_back(parameter);
    }
  }
  if (names.empty()) {
    for (const auto& [id, offer] : services_.offers()) {
      const std::string& service = offer.service.name;
      if (service.ends_with(kList) && offer.service.type == ListParameters::ros_name)
        wanted[service.substr(0, service.size() - std::string_view(kList).size())];
    }
  }
  answer->open += wanted.size();
  for (const auto& [node, parameters] : wanted) {
    know(node, [this, node = node, parameters = parameters, answer](const std::string& error) {
      if (!error.empty()) {
        answer->errors.push_back(error);
      } else if (parameters.empty()) {
        add_all(node, *answer);
      } else {
        for (const std::string& parameter : parameters) add(node, parameter, *answer);
      }
      answer->end_one();
    });
  }
  answer->end_one();
}

void WireParameters::add_all(const std::string& node, Answer& answer) const {
  const auto known = nodes_.find(node);
  if (known == nodes_.end()) return;
  for (const auto& [name, value] : known->second.values) answer.values.push_back({node + "." + name, value});
}

void WireParameters::add(const std::string& node, const std::string& parameter, Answer& answer) const {
  const auto known = nodes_.find(node);
  if (known != nodes_.end()) {
    const auto value = known->second.values.find(parameter);
    if (value != known->second.values.end()) {
      answer.values.push_back({node + "." + parameter, value->second});
      return;
    }
  }
  answer.errors.push_back(unknown(node + "." + parameter));
}

void WireParameters::set(const std::vector<NamedValue>& parameters, Robot::Values values) {
  const auto answer = std::make_shared<Answer>();
  answer->give = std::move(values);
  std::map<std::string, std::vector<NamedValue>> changes;
  for (const NamedValue& one : parameters) {
    const auto [node, parameter] = parts(one.name);
    if (node.empty()) {
      answer->errors.push_back(unknown(one.name));
    } else {
      changes[node].push_back({parameter, one.value});
    }
  }
  answer->open += changes.size();
  for (const auto& [node, its] : changes) {
    know(node, [this, node = node, its = its, answer](const std::string& error) {
      if (error.empty()) return change(node, its, answer);
      answer->errors.push_back(error);
      answer->end_one();
    });
  }
  answer->end_one();
}

/// JSON knows one kind of number: a value gets the type that the parameter has, where it can.
void WireParameters::change(const std::string& node, const std::vector<NamedValue>& changes,
                            const AnswerPtr& answer) {
  SetParameters::Request request;
  std::vector<std::string> names;
  const std::map<std::string, ParameterValue>& known = nodes_[node].values;
  for (const NamedValue& one : changes) {
    const auto now = known.find(one.name);
    const ParameterValue value = now == known.end() ? one.value : closest_type(one.value, now->second);
    request.parameters().push_back(to_message(NamedValue{one.name, value}));
    names.push_back(one.name);
  }
  call<SetParameters>(
      node, kSet, request,
      [this, node, names, answer](const SetParameters::Response* response, const std::string& error) {
        if (response == nullptr) {
          answer->errors.push_back(error);
          return answer->end_one();
        }
        for (std::size_t i = 0; i < names.size() && i < response->results().size(); ++i) {
          const auto& result = response->results()[i];
          if (!result.successful())
            answer->errors.push_back(node + "." + names[i] + ": " + std::string(result.reason()));
        }
        read_back(node, names, answer);
      });
}

void WireParameters::read_back(const std::string& node, const std::vector<std::string>& names,
                               const AnswerPtr& answer) {
  GetParameters::Request request;
  request.names(names);
  call<GetParameters>(
      node, kGet, request,
      [this, node, names, answer](const GetParameters::Response* response, const std::string& error) {
        if (response == nullptr) answer->errors.push_back(error);
        // Empty where one of the names is unknown: then it has an error already.
        const bool is_whole = response != nullptr && response->values().size() == names.size();
        for (std::size_t i = 0; is_whole && i < names.size(); ++i) {
          const ParameterValue value = from_message(response->values()[i]);
          if (const auto known = nodes_.find(node); known != nodes_.end())
            known->second.values[names[i]] = value;
          answer->values.push_back({node + "." + names[i], value});
        }
        answer->end_one();
      });
}

void WireParameters::hear_events() {
  dds::Sample sample;
  ParameterEvent event;
  std::vector<NamedValue> told;
  while (events_->take(sample)) {
    if (!deserialize(sample.cdr, event)) continue;
    const std::string node(event.node());
    const auto known = nodes_.find(node);
    const auto apply = [&](const NamedValue& one) {
      if (known != nodes_.end()) known->second.values[one.name] = one.value;
      told.push_back({node + "." + one.name, one.value});
    };
    for (const NamedValue& one : from_messages(event.new_parameters())) apply(one);
    for (const NamedValue& one : from_messages(event.changed_parameters())) apply(one);
    for (const NamedValue& one : from_messages(event.deleted_parameters())) {
      if (known != nodes_.end()) known->second.values.erase(one.name);
      told.push_back({node + "." + one.name, {}});
    }
  }
  if (!told.empty() && link_.listener != nullptr) link_.listener->on_parameters(told);
}

}  // namespace bw::foxglove
