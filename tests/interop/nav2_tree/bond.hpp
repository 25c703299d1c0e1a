// bondcpp's half of a bond on the manager's side: beats every 0.1 s from the start, formed with the other
// side's first beat, broken when 4 s pass without one or the other side says that it ends. A topic for all
// bonds, told apart by the id.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/interop/nav2_tree/messages.hpp"
#include "tests/interop/nav2_tree/tree_nodes.hpp"
#include "tests/interop/plain/node.hpp"

namespace nav2 {

inline constexpr std::chrono::milliseconds kBondTimeout{4000};
inline constexpr std::chrono::milliseconds kBeatPeriod{100};

class Bonds {
 public:
  explicit Bonds(plain::Node& node);

  void start(const std::string& id) { bonds_[id] = {.instance = "bond-" + std::to_string(++count_)}; }
  /// Says the end to the other side, once.
  void end(const std::string& id);
  void forget() { bonds_.clear(); }
  /// Beats where one is due and hears what came; to be called often.
  void poll();

  bool is_formed(const std::string& id) const { return bonds_.contains(id) && bonds_.at(id).is_formed; }
  bool is_broken(const std::string& id) const { return bonds_.contains(id) && bonds_.at(id).is_broken; }

 private:
  struct Bond {
    std::string instance;
    bool is_formed = false;
    bool is_broken = false;
    Clock::time_point said = {};
    Clock::time_point heard = {};
  };
  void say(const std::string& id, Bond& bond, bool is_active);

  std::map<std::string, Bond> bonds_;
  plain::dds::DataWriter* out_;
  plain::dds::DataReader* in_;
  int count_ = 0;
};

}  // namespace nav2
