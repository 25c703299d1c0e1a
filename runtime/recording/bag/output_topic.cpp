#include "runtime/recording/bag/output_topic.hpp"

#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {

BagTopic topic_of(const OutputEnd& output) {
  const TypeDescription* type = find_type(output.type.ros_name, output.type.type_hash);
  BagTopic topic{.name = output.topic,
                 .type = std::string(output.type.ros_name),
                 .writer = output.owner.name,
                 .offered_qos_profiles = to_qos_text({output.qos}),
                 .type_hash = std::string(output.type.type_hash),
                 .schema_encoding = type == nullptr ? "unknown" : "ros2msg"};
  if (type != nullptr) topic.schema_text = schema_text(*type);
  return topic;
}

}  // namespace bw::bag
