// A message of any type that is known by its description alone: its fields are set by their paths, and it is
// written as the class of the type would be. What nobody sets is zero, empty, false; an unset quaternion is
// no rotation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::imports {

class MessageDraft {
 public:
  enum class Kind {
    number,  ///< and a truth value: 0 or 1
    text,
    numbers,  ///< a whole array or sequence of numbers
    time,     ///< builtin_interfaces/Time or Duration
    angle,    ///< roll, pitch or yaw of a geometry_msgs/Quaternion
  };
  /// Where in the message something is set.
  struct Target {
    Kind kind = Kind::number;
    std::vector<std::size_t> steps;  ///< from the message down
    std::size_t element = 0;  ///< of an array of numbers or texts; of a quaternion: 0 roll, 1 pitch, 2 yaw
    const FieldDescription* field = nullptr;
    bool is_element = false;
  };

  explicit MessageDraft(const TypeDescription& type);

  /// `pose.pose.position.x`, `position_covariance[4]`, `transforms[0].child_frame_id`, `ranges`,
  /// `header.stamp`, `pose.pose.orientation.yaw`. Sequences grow as far as they are spoken of. Throws
  /// std::invalid_argument with the rule that the path breaks.
  Target find(std::string_view path);

  /// Each returns the rule that the value breaks, if it does: a whole number in range where the field is one,
  /// a text within its bound, as many numbers as an array has.
  std::optional<std::string> set(const Target& target, double value);
  std::optional<std::string> set(const Target& target, std::string_view text);
  std::optional<std::string> set(const Target& target, std::span<const double> values);
  std::optional<std::string> set(const Target& target, Duration since_epoch);
  /// In every std_msgs/Header of the message, and in a message that begins with a builtin_interfaces/Time
  /// there.
  void set_stamps(Time stamp);

  /// Of a target of kind numbers or number.
  [[nodiscard]] std::span<const double> numbers(const Target& target) const;

  /// Replaces `cdr`.
  void write(std::vector<std::uint8_t>& cdr) const;

 private:
  struct Node {
    const FieldDescription* field = nullptr;  ///< null: the message itself
    const TypeDescription* type = nullptr;    ///< of a single message or an element
    std::vector<Node> children;               ///< fields, or elements
    std::vector<double> numbers;              ///< a scalar has one
    std::vector<std::string> texts;
  };

  static Node make(const FieldDescription& field);
  static void fill(Node& node, const TypeDescription& type);
  static const FieldDescription& field_of(const Node& node, std::string_view name);
  static Node& element_of(Node& list, std::size_t index, Target& target);
  static Kind kind_of(const Node& node, const Target& target);
  static void set_stamps(Node& node, Time stamp, bool is_first);
  Node& node(const Target& target);
  [[nodiscard]] const Node& node(const Target& target) const;

  Node root_;
};

}  // namespace bw::imports
