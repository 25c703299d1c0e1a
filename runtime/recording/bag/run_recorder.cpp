#include "runtime/recording/bag/run_recorder.hpp"

#include "runtime/recording/bag/message_stamp.hpp"
#include "runtime/recording/bag/output_topic.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {

void RunRecorder::connect(const std::vector<const OutputEnd*>& outputs) {
  for (const OutputEnd* output : outputs) {
    const TypeDescription* type = find_type(output->type.ros_name, output->type.type_hash);
    topics_[output] = {recorder_.add_topic(topic_of(*output)), type != nullptr && begins_with_stamp(*type)};
  }
}

void RunRecorder::on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) {
  const Topic& topic = topics_.at(&output);
  const Time stamp = topic.has_stamp ? stamp_of(cdr).value_or(now) : now;
  recorder_.record(topic.number, now, stamp, cdr);
}

}  // namespace bw::bag
