// A second, independent hand at type hashes: reads .msg, .srv and .action files and computes RIHS01 as REP
// 2011 has it. Shares no code with idl/compiler; the tests hold what it exports against this.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bw::test {

struct TextField {
  std::string name;
  int type_id = 0;  ///< of type_description_interfaces/msg/FieldType
  std::uint64_t capacity = 0;
  std::uint64_t string_capacity = 0;
  std::string nested;  ///< nav_msgs/msg/Path
};

/// Every type that ROS 2 makes of the files read so far, those derived for services and actions included.
class InterfaceTexts {
 public:
  /// The text of <package>/<category>/<name>.<category>. Throws std::runtime_error on what rosidl would
  /// refuse: a line that is neither field nor constant, a name against its rules.
  void read(const std::string& package, const std::string& category, const std::string& name,
            const std::string& text);

  /// "RIHS01_..." by ROS name. Throws std::out_of_range if a type refers to one that was not read.
  [[nodiscard]] std::map<std::string, std::string> hashes() const;

 private:
  std::map<std::string, std::vector<TextField>> types_;
};

}  // namespace bw::test
