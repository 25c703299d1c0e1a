// The bonds of this process's components with a manager from outside (bond/msg/Status, as bondcpp): while a
// component is active its bond beats, so that a process that died is missed within seconds. One writer and
// one reader per namespace serve all components: a bond is told by its id, the node's name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <bond/msg/status.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

class Bonds {
 public:
  static constexpr Duration kPeriod = Duration::milliseconds(100);
  static constexpr Duration kTimeout = Duration::milliseconds(4'000);

  /// `actors` is read at every beat.
  explicit Bonds(const std::vector<Actor*>& actors) : actors_(actors) {}

  /// One /bond for each of the namespaces.
  void configure(Setup& setup, const std::vector<std::string>& namespaces);

 private:
  struct Bond {
    std::uint64_t activation = 0;  ///< each has its own bond
    std::string instance;
    bool is_formed = false;  ///< the manager's side was heard
    bool is_over = false;
    Time heard;
    int farewells = 0;  ///< left to say
  };

  void beat(Time now);
  void beat(const Actor& actor, Time now);
  void part(const Actor& actor, Bond& bond, Time now);
  void hear(const std::string& node_namespace, const bond::msg::Status& status, Time now);
  void say(const Actor& actor, const Bond& bond, bool is_active, Time now);

  const std::vector<Actor*>& actors_;
  std::map<std::string, Output<bond::msg::Status>> outputs_;  ///< by namespace
  std::map<const Actor*, Bond> bonds_;
  Logger log_;
};

}  // namespace bw
