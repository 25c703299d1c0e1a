// The part of tf2's buffer that bt_navigator needs: where base_link is in map, and how old that is. Servers
// of Nav2 refuse to work with a pose older than their transform_tolerance, 0.1 s unless set.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tests/interop/nav2_tree/messages.hpp"
#include "tests/interop/plain/node.hpp"

namespace nav2 {

class Frames {
 public:
  explicit Frames(plain::Node& node);
  void poll();
  /// Of base_link in map; nothing while a link of the way up is missing.
  std::optional<Pose> pose() const;
  /// [s] by which the oldest link of that way lies behind `now`, seconds since the epoch; negative when it is
  /// ahead.
  std::optional<double> age(double now) const;

 private:
  struct Link {
    std::string parent;
    double stamp = 0.0;
    bool is_static = false;
    Pose pose;
  };
  std::optional<std::vector<Link>> links_up() const;
  void take(plain::dds::DataReader& reader, bool is_static);

  plain::dds::DataReader* moving_;
  plain::dds::DataReader* fixed_;
  std::map<std::string, Link> links_;  ///< by child
};

}  // namespace nav2
