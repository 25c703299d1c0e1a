#include "runtime/recording/bag/message_stamp.hpp"

#include "runtime/wire/cdr_reader.hpp"

namespace bw::bag {

bool begins_with_stamp(const TypeDescription& type) {
  if (type.fields.empty() || type.fields.front().shape != Shape::kSingle) return false;
  const TypeDescription* first = type.fields.front().message;
  if (first == nullptr) return false;
  return first->ros_name == "builtin_interfaces/msg/Time" || first->ros_name == "std_msgs/msg/Header";
}

std::optional<Time> stamp_of(BytesView cdr) {
  CdrReader reader(cdr);
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  if (!reader.open() || !reader.read(sec) || !reader.read(nanosec)) return std::nullopt;
  return Time{std::int64_t{sec} * 1'000'000'000 + nanosec};
}

}  // namespace bw::bag
