#include "runtime/host/rebinding.hpp"

#include <stdexcept>
#include <utility>

namespace bw {
namespace {

bool is_same(const MessageType& a, const MessageType& b) { return a.ros_name == b.ros_name; }

}  // namespace

void Rebinding::refuse(const std::string& name) const {
  throw std::runtime_error("the ends of " + actor_.name + " changed (" + name + "): start the graph anew");
}

/// The first end of this kind that nobody declared again yet: a component may declare one name twice.
template <class Ends, class Same>
auto& Rebinding::take(const Ends& ends, const std::string& name, Same same) {
  for (const auto& end : ends) {
    if (!end->of_node && end->name == name && same(*end) && taken_.insert(end.get()).second) return *end;
  }
  refuse(name);
}

OutputPort* Rebinding::output(const std::string& name, const MessageType& type, const Qos& qos,
                              bool command) {
  return &take(actor_.outputs, name, [&](const OutputEnd& end) {
    return is_same(end.type, type) && end.qos == qos && end.command == command;
  });
}

void Rebinding::input(const std::string& name, const MessageType& type, const Qos& qos, InputKind kind,
                      SampleHandler handler) {
  Input& end = take(actor_.inputs, name, [&](const Input& input) {
    return is_same(input.type, type) && input.qos == qos && input.kind == kind;
  });
  changes_.emplace_back([&end, handler = std::move(handler)]() mutable { end.handler = std::move(handler); });
}

void Rebinding::timer(const std::string& name, Duration period, TickHandler handler) {
  Timer& end = take(actor_.timers, name, [](const Timer&) { return true; });
  changes_.emplace_back([&end, period, handler = std::move(handler)]() mutable {
    end.period = period;
    end.handler = std::move(handler);
  });
}

ServiceEnd& Rebinding::service(const std::string& name, const ServiceType& type) {
  return take(actor_.services, name,
              [&](const ServiceEnd& end) { return end.type.ros_name == type.ros_name; });
}

void Rebinding::request_handler(ServiceEnd& end, RequestHandler handler) {
  changes_.emplace_back([&end, handler = std::move(handler)]() mutable { end.handler = std::move(handler); });
}

ActionEnd& Rebinding::action(const std::string& name, const ActionType& type) {
  return take(actor_.actions, name, [&](const ActionEnd& end) { return end.type.ros_name == type.ros_name; });
}

/// What the wire asks is answered as before: nothing of an instance is in it.
void Rebinding::action_handler(ActionEnd& end, ActionHandler handler) {
  changes_.emplace_back([&end, handler = std::move(handler)]() mutable {
    end.handler.on_goal = std::move(handler.on_goal);
    end.handler.on_cancel = std::move(handler.on_cancel);
  });
}

ClientPort* Rebinding::client(const std::string& name, const ServiceType& type) {
  return &take(actor_.clients, name,
               [&](const ClientEnd& end) { return end.type.ros_name == type.ros_name; });
}

void Rebinding::commit() {
  const auto look_for_left_out = [this](const auto& ends) {
    for (const auto& end : ends) {
      if (!end->of_node && !taken_.contains(end.get())) refuse(end->name);
    }
  };
  look_for_left_out(actor_.outputs);
  look_for_left_out(actor_.inputs);
  look_for_left_out(actor_.timers);
  look_for_left_out(actor_.services);
  look_for_left_out(actor_.actions);
  look_for_left_out(actor_.clients);
  for (const auto& change : changes_) change();
}

}  // namespace bw
