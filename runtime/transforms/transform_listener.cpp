#include <tf2_msgs/msg/tf_message.hpp>

#include "runtime/component.hpp"
#include "runtime/transforms/transform_message.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

void add_all(TransformTree& tree, const tf2_msgs::msg::TFMessage& message, bool is_static) {
  for (const auto& t : message.transforms()) {
    const Time stamp{t.header().stamp().sec() * std::int64_t{1'000'000'000} + t.header().stamp().nanosec()};
    tree.set(t.header().frame_id(), t.child_frame_id(), stamp, to_isometry(t.transform()), is_static);
  }
}

}  // namespace

std::shared_ptr<const TransformTree> Setup::transforms() {
  auto tree = std::make_shared<TransformTree>();
  const auto listen = [&](const char* topic, const Qos& qos, bool is_static) {
    auto message = std::make_shared<tf2_msgs::msg::TFMessage>();
    add_input(topic, message_type<tf2_msgs::msg::TFMessage>(), qos, InputKind::keep_newest, Need::optional,
              [tree, message, is_static](std::span<const std::uint8_t> cdr, const Tick&) {
                if (!deserialize(cdr, *message)) return false;
                add_all(*tree, *message, is_static);
                return true;
              });
  };
  listen("/tf", Qos::tf(), false);
  listen("/tf_static", Qos::tf_static(), true);
  return tree;
}

}  // namespace bw
