#include "runtime/host/host_setup.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "runtime/base/named_seed.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/rebinding.hpp"
#include "runtime/host/writer_names.hpp"
#include "runtime/ros/node_directory.hpp"
#include "runtime/state_folder.hpp"

namespace bw {

std::filesystem::path HostSetup::file_parameter(std::string_view key) const {
  const ConfigNode* value = find_dotted(node_.parameters, key);
  if (value == nullptr || !value->is_scalar() || value->scalar.empty()) return {};
  return resolve_path(value->where, value->scalar);
}

void HostSetup::every(Duration period, const std::string& name, TickHandler on_tick) {
  if (period <= Duration{})
    throw std::logic_error(actor_.name + ": the timer " + name + " has no positive period");
  if (rebinding_ != nullptr) return rebinding_->timer(name, period, std::move(on_tick));
  auto timer = std::make_unique<Timer>();
  timer->actor = &actor_;
  timer->name = name;
  timer->of_node = of_node_;
  timer->period = period;
  timer->handler = std::move(on_tick);
  timer->statistics.component = actor_.name;
  timer->statistics.callback = name;
  actor_.timers.push_back(std::move(timer));
}

std::string HostSetup::frame(std::string_view name) const {
  if (name == "map") return "map";
  const std::string of_robot = node_.robot.empty() ? "" : node_.robot + "/";
  return host_.graph().settings.frame_prefix + of_robot + std::string(name);
}

std::uint64_t HostSetup::seed() const { return named_seed(actor_.name, host_.options_.seed); }

bool HostSetup::is_lockstep() const { return host_.options_.clock == ClockMode::lockstep; }

// What a replay is given may hold what came from outside.
bool HostSetup::accepts_inputs() const {
  return !is_lockstep() || host_.options_.accept_inputs || host_.options_.source != nullptr;
}

dds::Network HostSetup::network() const { return host_.network(); }

std::filesystem::path HostSetup::state_file(const std::string& name) const {
  const std::string node =
      full_name({.node_namespace = actor_.node_namespace, .name = actor_.node_name}).substr(1);
  return state_folder() / ("domain_" + std::to_string(network().domain_id)) / node / name;
}

/// An instance that is configured anew has the rows that the one before it had.
Failsafe HostSetup::failsafe(FailsafeRow row) {
  const auto known = std::ranges::find(actor_.failsafes, row.name,
                                       [](const Actor::DeclaredFailsafe& f) { return f.row.name; });
  Actor::DeclaredFailsafe& declared =
      known != actor_.failsafes.end() ? *known : actor_.failsafes.emplace_back();
  const std::lock_guard lock(actor_.mutex);
  declared.row = std::move(row);
  declared.in_force = false;
  return Failsafe(&declared.in_force);
}

Keepsake HostSetup::keepsake(const std::string& name) const {
  const char* folder = std::getenv("RUNTIME_DIRECTORY");
  if (is_lockstep() || folder == nullptr || *folder != '/') return {};
  const std::string node = full_name({.node_namespace = actor_.node_namespace, .name = actor_.node_name});
  return Keepsake(std::string(folder) + node + "." + name, rebinding_ == nullptr);
}

Writers& HostSetup::writers() { return *host_.writers_; }

// An instance that comes later finds it there.
std::shared_ptr<void> HostSetup::keep_part(std::function<std::shared_ptr<void>(Setup&)> make) {
  if (actor_.part != nullptr) return actor_.part;
  const bool of_node = std::exchange(of_node_, true);
  of_part_ = true;
  actor_.part = make(*this);
  of_part_ = false;
  of_node_ = of_node;
  return actor_.part;
}

RosDistro HostSetup::ros_distro() const {
  const RosDistro distro = host_.graph().settings.ros_distro;
  return distro == RosDistro::automatic ? RosDistro::jazzy : distro;
}

Logger HostSetup::log() {
  return Logger([&host = host_, &actor = actor_](LogLevel level, const std::string& text) {
    host.log(actor, level, text);
  });
}

std::function<void(bool, const std::string&)> HostSetup::finish_run() {
  return [&host = host_](bool ok, const std::string& reason) {
    host.finish({.ok = ok, .reason = reason}, true);
  };
}

OutputPort* HostSetup::add_output(const std::string& topic, const MessageType& type, const Qos& qos,
                                  bool command) {
  if (rebinding_ != nullptr) return rebinding_->output(topic, type, qos, command);
  auto output = std::make_unique<OutputEnd>(actor_, node_.topic_of(topic), type, qos, command);
  output->name = topic;
  output->of_node = of_node_;
  actor_.outputs.push_back(std::move(output));
  return actor_.outputs.back().get();
}

void HostSetup::add_input(const std::string& topic, const MessageType& type, const Qos& qos, InputKind kind,
                          Need need, SampleHandler handler) {
  if (rebinding_ != nullptr) return rebinding_->input(topic, type, qos, kind, std::move(handler));
  auto input = std::make_unique<Input>();
  input->actor = &actor_;
  input->name = topic;
  input->of_node = of_node_;
  const auto is_same = [&](const auto& other) { return other->name == topic; };
  input->is_declared = !of_node_ || (of_part_ && std::ranges::none_of(actor_.inputs, is_same));
  input->topic = node_.topic_of(topic);
  input->type = type;
  input->qos = qos;
  input->handler = std::move(handler);
  input->kind = kind;
  input->need = need;
  if (const InputSettings* settings = node_.input(topic)) {
    input->is_external = settings->external;
    input->max_age = settings->max_age;
    input->on_stale = settings->on_stale;
    if (input->max_age) actor_.watched.push_back(input.get());
  }
  input->statistics.component = actor_.name;
  input->statistics.callback = topic;
  actor_.inputs.push_back(std::move(input));
}

void HostSetup::keep_parameters(ParameterReport report, ParameterDeclaration declaration) {
  actor_.parameters = std::move(report);
  actor_.live_parameters.declare(std::move(declaration));
}

void HostSetup::keep_shared_parameters(std::string_view section, ParameterReport report,
                                       ParameterSet values) {
  actor_.shared_parameters.insert_or_assign(std::string(section), std::move(report));
  actor_.live_parameters.declare_read_only(std::string(section), std::move(values),
                                           "components share it; it is set in the graph");
}

ServicePort& HostSetup::add_service(const std::string& name, const ServiceType& type, ServiceScope scope) {
  if (rebinding_ != nullptr) return rebinding_->service(name, type);
  actor_.services.push_back(std::make_unique<ServiceEnd>(actor_, name, node_.topic_of(name), type, scope));
  actor_.services.back()->of_node = of_node_;
  return *actor_.services.back();
}

// A request from outside of a run in lock-step is a message of that run: recorded, and heard again by a
// replay.
void HostSetup::set_handler(ServicePort& port, RequestHandler handler) {
  auto& end = static_cast<ServiceEnd&>(port);
  const bool hears_events = host_.options_.accept_inputs || host_.options_.source != nullptr;
  const bool is_in_the_run = handler.refuse != nullptr && is_lockstep() && hears_events;
  if (rebinding_ != nullptr) return rebinding_->request_handler(end, std::move(handler));
  end.handler = std::move(handler);
  if (!is_in_the_run) return;
  add_input(end.name + kServiceEvent, end.type.event, Qos::standard(1000), InputKind::callback,
            Need::optional, [&end](std::span<const std::uint8_t> cdr, const Tick& tick) {
              ServiceEnd::Request request;
              if (!end.handler.from_event(cdr, request.from, request.cdr)) return false;
              end.answer(request, tick.now);
              return true;
            });
  actor_.inputs.back()->of_node = true;  // answered in every state, if only by a refusal
}

// Its ends are the node's: they answer in every state of the component.
ActionPort& HostSetup::add_action(const std::string& name, const ActionType& type) {
  if (rebinding_ != nullptr) return rebinding_->action(name, type);
  const bool of_node = std::exchange(of_node_, true);
  const std::string part = name + "/_action/";
  const auto service = [&](const char* which, const ServiceType& its_type) {
    auto& end = static_cast<ServiceEnd&>(add_service(part + which, its_type, ServiceScope::node));
    end.off_lane = true;
    return &end;
  };
  const auto output = [&](const char* which, const MessageType& its_type, const Qos& qos) {
    return static_cast<OutputEnd*>(add_output(part + which, its_type, qos, false));
  };
  const ActionEnd::Ends ends{.send_goal = service("send_goal", type.send_goal),
                             .cancel_goal = service("cancel_goal", type.cancel_goal),
                             .get_result = service("get_result", type.get_result),
                             .feedback = output("feedback", type.feedback, Qos::standard()),
                             .status = output("status", type.status, Qos::latched())};
  of_node_ = of_node;
  actor_.actions.push_back(std::make_unique<ActionEnd>(actor_, name, node_.topic_of(name), type, ends,
                                                       ActionEnd::result_timeout(ros_distro())));
  return *actor_.actions.back();
}

void HostSetup::set_action(ActionPort& port, ActionHandler handler) {
  auto& end = static_cast<ActionEnd&>(port);
  if (rebinding_ != nullptr) return rebinding_->action_handler(end, std::move(handler));
  set_handler(*end.ends.send_goal, std::move(handler.send_goal));
  set_handler(*end.ends.cancel_goal, std::move(handler.cancel_goal));
  set_handler(*end.ends.get_result, std::move(handler.get_result));
  end.handler = std::move(handler);
}

ClientPort* HostSetup::add_client(const std::string& name, const ServiceType& type, Need need) {
  if (rebinding_ != nullptr) return rebinding_->client(name, type);
  actor_.clients.push_back(std::make_unique<ClientEnd>(actor_, name, node_.topic_of(name), type, need));
  actor_.clients.back()->of_node = of_node_;
  return actor_.clients.back().get();
}

const ConfigNode& HostSetup::shared_section(std::string_view section) const {
  static const ConfigNode kNothing{};
  const std::size_t dot = section.find('.');
  const auto found = host_.graph().shared.find(std::string(section.substr(0, dot)));
  if (found == host_.graph().shared.end()) return kNothing;
  if (dot == std::string_view::npos) return found->second;
  const ConfigNode* within = found->second.find(section.substr(dot + 1));
  return within == nullptr ? kNothing : *within;
}

// What a graph does not mention stays where it is.
void HostSetup::comes_to_rest_within(std::string_view section, Duration time) {
  if (host_.graph().shared.contains(std::string(section)) && time > host_.time_to_rest_)
    host_.time_to_rest_ = time;
}

}  // namespace bw
