// What our own reader and decoder make of a bag, as text that another decoder's words are compared with; and
// a bag with messages of every type to compare.
//
//   bag_leaves show BAG                 a line "@ TOPIC LOG_TIME PUBLISH_TIME" for each message, then one for each value
//   bag_leaves make OUT COMPRESSION     random messages of every type of the build
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/leaves.hpp"
#include "runtime/wire/type_registry.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::bag {
namespace {

/// No rounding, no quotes: the bits of a float64 and the bytes of a text in hexadecimal.
std::string exact(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value));
}
std::string exact(const std::string& text) {
  std::string hex = "x";
  for (const char c : text) hex += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return hex;
}
template <class T>
std::string exact(const T& value) {
  return fmt::format("{}", value);
}

int show(const std::string& path) {
  const auto recording = open_bag(path);
  const auto messages = recording->messages({});
  BagMessage m;
  for (Step step = messages->next(m); step != Step::end; step = messages->next(m)) {
    if (step == Step::damaged) throw std::runtime_error(messages->fault().what);
    const BagTopic& topic = recording->topics()[m.topic];
    const TypeDescription* type = find_type(topic.type);
    if (type == nullptr) throw std::runtime_error(topic.type + " is not of this build");
    fmt::print("@ {} {} {}\n", topic.name, m.log_time.nanoseconds, m.publish_time.nanoseconds);
    for (const Leaf& leaf : leaves_of(*type, m.data)) {
      if (leaf.path.ends_with(kEmptyMessageMember)) continue;  // no tool of ROS 2 shows it
      fmt::print("{} {}\n", leaf.path, std::visit([](const auto& v) { return exact(v); }, leaf.value));
    }
  }
  return 0;
}

/// A sweep whose ranges are what floats can be at worst.
std::vector<std::uint8_t> worst_scan() {
  using Limits = std::numeric_limits<float>;
  test::CdrWriter scan;
  scan.header(-1, 999'999'999, "l\xC3\xA4ser").floats(-0.0, 1e-45F, 3.4e38F, 0.1F, 0.2F, 0.3F, 0.4F);
  scan.put(std::uint32_t{6}).floats(Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), -0.0F);
  scan.floats(Limits::denorm_min(), Limits::max()).put(std::uint32_t{0});
  return scan.bytes();
}

int make(const std::string& path, std::string_view compression) {
  constexpr int kOfEachType = 20;
  BagWriter writer(path, {.compression = compression_of(compression).value()});
  test::RandomPayload random(12, 5);
  Time now{1'000'000'000};
  for (const TypeDescription* type : all_types()) {
    const std::size_t topic = writer.add_topic({.name = "/" + std::string(type->ros_name),
                                                .type = std::string(type->ros_name),
                                                .type_hash = std::string(type->type_hash),
                                                .schema_encoding = "ros2msg",
                                                .schema_text = schema_text(*type)});
    for (int i = 0; i < kOfEachType; ++i, now = now + Duration::milliseconds(1))
      writer.write(topic, now, now, random(*type));
    if (type->ros_name == "sensor_msgs/msg/LaserScan") writer.write(topic, now, now, worst_scan());
  }
  writer.close();
  return 0;
}

}  // namespace
}  // namespace bw::bag

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "show") return bw::bag::show(arguments[1]);
    if (arguments.size() == 3 && arguments[0] == "make") return bw::bag::make(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: bag_leaves show BAG | make OUT COMPRESSION\n");
  return 2;
}
