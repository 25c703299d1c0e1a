// The parameters of all nodes of a domain, asked for by their services and kept up by /parameter_events: who
// asks often costs them nothing. A name is /local_planner.teb.weight_obstacle: the node's full name, a dot,
// the parameter's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/foxglove/wire_link.hpp"
#include "runtime/remote/foxglove/wire_services.hpp"

namespace bw::foxglove {

class WireParameters {
 public:
  WireParameters(WireLink& link, WireServices& services);

  /// Forgets nodes that are gone or came back. After WireServices::look().
  void look();

  // As Robot has them.
  void get(const std::vector<std::string>& names, Robot::Values values);
  void set(const std::vector<NamedValue>& parameters, Robot::Values values);

 private:
  struct Node {
    std::set<dds::Guid> servers;  ///< of which it is known
    bool is_known = false;
    std::map<std::string, ParameterValue> values;
    std::vector<std::function<void(const std::string& error)>> waiting;  ///< for is_known
  };
  /// One request over several nodes.
  struct Answer {
    std::size_t open = 1;
    std::vector<NamedValue> values;
    std::vector<std::string> errors;
    Robot::Values give;
    void end_one();
  };
  using AnswerPtr = std::shared_ptr<Answer>;

  /// Calls back with an error, or nothing when all values of the node are known.
  void know(const std::string& node, std::function<void(const std::string& error)> then);
  void list(const std::string& node);
  void fetch(const std::string& node, const std::vector<std::string>& names);
  void end_knowing(const std::string& node, const std::string& error);
  void add_all(const std::string& node, Answer& answer) const;
  void add(const std::string& node, const std::string& parameter, Answer& answer) const;
  void change(const std::string& node, const std::vector<NamedValue>& changes, const AnswerPtr& answer);
  void read_back(const std::string& node, const std::vector<std::string>& names, const AnswerPtr& answer);
  void hear_events();

  template <class S>
  void call(const std::string& node, const char* service, const typename S::Request& request,
            std::function<void(const typename S::Response* response, const std::string& error)> then);

  WireLink& link_;
  WireServices& services_;
  std::map<std::string, Node> nodes_;  ///< by full name; those that were asked
  PostedTask hearing_;
  std::unique_ptr<dds::Reader> events_;
};

}  // namespace bw::foxglove
