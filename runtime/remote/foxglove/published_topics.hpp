// Topics on which clients publish: several may share one, of one type.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/remote/foxglove/robot.hpp"

namespace bw::foxglove {

class PublishedTopics {
 public:
  explicit PublishedTopics(Robot& robot) : robot_(robot) {}

  /// What is wrong, or nothing; then it is to be released once. `type` in either spelling.
  std::optional<std::string> acquire(const std::string& topic, const std::string& type);
  void release(const std::string& topic);

 private:
  struct Use {
    std::string type;
    int count = 0;
  };
  Robot& robot_;
  std::map<std::string, Use> uses_;
};

/// geometry_msgs/msg/PoseStamped of itself and of geometry_msgs/PoseStamped; nothing for what is neither.
std::optional<std::string> full_type_name(std::string_view type);

}  // namespace bw::foxglove
