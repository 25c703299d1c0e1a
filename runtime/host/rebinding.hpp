// The ends of an actor handed to a new instance of its component. Endpoints on the wire live as long as the
// process: a component that is configured again declares the ends it declared before, and gets them. Nothing
// changes for the instance before until commit().
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "runtime/host/actor.hpp"

namespace bw {

class Rebinding {
 public:
  explicit Rebinding(Actor& actor) : actor_(actor) {}

  // Each throws std::runtime_error when the actor has no such end left.
  OutputPort* output(const std::string& name, const MessageType& type, const Qos& qos, bool command);
  void input(const std::string& name, const MessageType& type, const Qos& qos, InputKind kind,
             SampleHandler handler);
  void timer(const std::string& name, Duration period, TickHandler handler);
  ServiceEnd& service(const std::string& name, const ServiceType& type);
  void request_handler(ServiceEnd& end, RequestHandler handler);
  ActionEnd& action(const std::string& name, const ActionType& type);
  void action_handler(ActionEnd& end, ActionHandler handler);
  ClientPort* client(const std::string& name, const ServiceType& type);

  /// From now on the ends call the new instance. Throws std::runtime_error when one was not declared again.
  void commit();

 private:
  template <class Ends, class Same>
  auto& take(const Ends& ends, const std::string& name, Same same);
  [[noreturn]] void refuse(const std::string& name) const;

  Actor& actor_;
  std::set<const void*> taken_;
  std::vector<std::function<void()>> changes_;
};

}  // namespace bw
