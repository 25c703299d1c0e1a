#include "runtime/bag/run_recorder.hpp"

#include "runtime/bag/message_stamp.hpp"
#include "runtime/bag/qos_text.hpp"
#include "runtime/bag/schema.hpp"
#include "runtime/host/actor.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {

void RunRecorder::connect(const std::vector<const OutputEnd*>& outputs) {
  for (const OutputEnd* output : outputs) {
    const TypeDescription* type = find_type(output->type.ros_name);
    BagTopic topic{.name = output->topic,
                   .type = std::string(output->type.ros_name),
                   .writer = output->owner.name,
                   .offered_qos_profiles = to_qos_text({output->qos}),
                   .type_hash = std::string(output->type.type_hash),
                   .schema_encoding = type == nullptr ? "unknown" : "ros2msg"};
    if (type != nullptr) topic.schema_text = schema_text(*type);
    topics_[output] = {recorder_.add_topic(topic), type != nullptr && begins_with_stamp(*type)};
  }
}

void RunRecorder::on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) {
  const Topic& topic = topics_.at(&output);
  const Time stamp = topic.has_stamp ? stamp_of(cdr).value_or(now) : now;
  recorder_.record(topic.number, now, stamp, cdr);
}

}  // namespace bw::bag
