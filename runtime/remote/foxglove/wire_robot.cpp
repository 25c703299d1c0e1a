#include "runtime/remote/foxglove/wire_robot.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <variant>

#include "runtime/remote/foxglove/message_json.hpp"
#include "runtime/ros/dds_names.hpp"

namespace bw::foxglove {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

WireRobot::WireRobot(WireRobotOptions options, Post post)
    : options_(std::move(options)),
      link_(options_.network, options_.node,
            {.distro = options_.distro, .looks_around = options_.looks_around}, std::move(post),
            [this] { has_names_ = true; }),
      clock_(link_),
      topics_(link_, clock_),
      services_(link_),
      parameters_(link_, services_),
      publisher_(link_, options_.refusal),
      ticking_(link_.post, [this] { tick(); }),
      thread_([this] { watch(); }) {}

WireRobot::~WireRobot() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

/// On a thread of its own: sees whether there is anything to do, and leaves it to the server's.
void WireRobot::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kPeriod, [this] { return stop_; })) {
    if (has_names_ || is_busy_ || link_.participant.endpoint_changes() != known_changes_) ticking_.ring();
  }
}

void WireRobot::tick() {
  link_.announcement.rethrow();
  const auto now = steady_clock::now();
  look();
  topics_.tick(now);
  services_.tick(now);
  publisher_.tick(now);
  clock_.tell_newest();
  link_.announce();
  update_is_busy();
}

void WireRobot::update_is_busy() {
  is_busy_ = topics_.is_listening() || services_.is_busy() || publisher_.is_busy();
}

/// Who is there, and which nodes those are.
void WireRobot::look() {
  const std::uint64_t changes = link_.participant.endpoint_changes();
  bool is_new = changes != known_changes_;
  if (has_names_.exchange(false)) is_new = link_.directory.update() || is_new;
  if (!is_new) return;
  known_changes_ = changes;
  std::vector<dds::Endpoint> endpoints = link_.participant.endpoints();
  std::erase_if(endpoints, [](const dds::Endpoint& e) { return e.is_local; });
  clock_.look(endpoints);
  topics_.look(endpoints);
  services_.look(endpoints);
  parameters_.look();
  ConnectionGraph graph = connection_graph(endpoints, link_.directory);
  if (graph == graph_) return;
  graph_ = std::move(graph);
  if (link_.listener != nullptr) link_.listener->on_graph();
}

void WireRobot::set_listener(RobotListener* listener) {
  link_.listener = nullptr;
  look();
  link_.listener = listener;
  clock_.forget_told();
  if (listener == nullptr) return;
  listener->on_channels(topics_.channels(), {});
  listener->on_services(services_.services(), {});
  listener->on_graph();
  for (const auto& [level, message] : link_.said) listener->on_status(level, message);
}

void WireRobot::subscribe(std::uint32_t channel) {
  topics_.subscribe(channel);
  update_is_busy();
}

std::vector<std::pair<Time, SharedBytes>> WireRobot::latched(std::uint32_t channel) const {
  return topics_.latched(channel);
}

std::optional<std::string> WireRobot::advertise(const std::string& topic, const std::string& type) {
  return publisher_.advertise(topic, type);
}

void WireRobot::unadvertise(const std::string& topic) {
  publisher_.unadvertise(topic);
  update_is_busy();
}

std::optional<std::string> WireRobot::publish(const std::string& topic, std::span<const std::uint8_t> cdr) {
  auto wrong = publisher_.publish(topic, cdr);
  update_is_busy();
  return wrong;
}

std::optional<std::string> WireRobot::publish_json(const std::string& topic, std::string_view json) {
  auto wrong = publisher_.publish_json(topic, json);
  update_is_busy();
  return wrong;
}

void WireRobot::call(std::uint32_t service, std::span<const std::uint8_t> cdr, Answer answer) {
  services_.call(service, cdr, std::move(answer));
  update_is_busy();
}

void WireRobot::call_json(std::uint32_t service, std::string_view json, Answer answer) {
  const WireServices::Offer* offer = services_.find(service);
  if (offer == nullptr) return answer("nobody offers this service any more");
  try {
    const auto as_json = [type = offer->response, answer](const std::variant<Bytes, std::string>& reply) {
      if (!std::holds_alternative<Bytes>(reply)) return answer(reply);
      const std::string text = message_to_json(*type, std::get<Bytes>(reply));
      answer(Bytes(text.begin(), text.end()));
    };
    call(service, message_from_json(*offer->request, json), as_json);
  } catch (const std::runtime_error& error) {
    answer(error.what());
  }
}

void WireRobot::get_parameters(const std::vector<std::string>& names, Values values) {
  parameters_.get(names, std::move(values));
  update_is_busy();
}

void WireRobot::set_parameters(const std::vector<NamedValue>& parameters, Values values) {
  parameters_.set(parameters, std::move(values));
  update_is_busy();
}

std::map<std::string, std::string> WireRobot::metadata() const {
  std::map<std::string, std::string> all = options_.metadata;
  const RosDistro distro = link_.announcement.distro().value_or(RosDistro::jazzy);
  all["ROS_DISTRO"] = std::string(text_of(distro));
  return all;
}

ConnectionGraph connection_graph(const std::vector<dds::Endpoint>& endpoints, const NodeDirectory& nodes) {
  ConnectionGraph graph;
  for (const dds::Endpoint& e : endpoints) {
    const std::string node = nodes.node_of(e.guid);
    if (node.empty()) continue;
    const std::string service = e.is_writer ? std::string() : service_of_request(e.topic);
    if (!service.empty()) graph.services[service].insert(node);
    if (e.topic.starts_with("rt/"))
      (e.is_writer ? graph.published : graph.subscribed)[ros_topic(e.topic)].insert(node);
  }
  return graph;
}

}  // namespace bw::foxglove
