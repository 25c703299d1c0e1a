#include "runtime/recording/bag/convert.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/recording/bag/schema.hpp"

namespace bw::bag {
namespace {

/// Older SQLite bags tell names of types only.
BagTopic with_schema(BagTopic topic) {
  if (!topic.schema_encoding.empty() || !topic.schema_text.empty() || topic.type.empty()) return topic;
  const TypeDescription* type = known_type(topic).type;
  topic.schema_encoding = type == nullptr ? "unknown" : "ros2msg";
  if (type != nullptr) topic.schema_text = schema_text(*type);
  return topic;
}

void copy_attachments(const Bag& from, BagWriter& to, std::vector<BagFault>& lost) {
  std::set<std::string> done;  // the parts of a split recording may repeat them
  for (const BagAttachment& a : from.attachments()) {
    if (!done.insert(a.name).second) continue;
    const std::optional<Bytes> content = from.attachment(a.name);
    if (content) {
      to.attach(a.name, a.media_type, {reinterpret_cast<const char*>(content->data()), content->size()},
                from.start());
    } else {
      lost.push_back({a.file, a.offset, "the attachment " + a.name + " is damaged"});
    }
  }
}

}  // namespace

ConvertReport convert(const Bag& from, const std::filesystem::path& to, Compression compression) {
  ConvertReport report{.lost = from.faults()};
  BagWriter writer(
      to,
      {.compression = compression, .profile = from.profile(), .ros_distro = ros_distro_in(from.metadata())});
  for (const BagTopic& topic : from.topics()) writer.add_topic(with_schema(topic));
  copy_attachments(from, writer, report.lost);
  for (const auto& [name, entries] : from.metadata()) {
    if (name != "rosbag2") writer.add_metadata(name, entries);  // the writer makes its own
  }
  const auto messages = from.messages({});
  BagMessage m;
  for (Step step = messages->next(m); step != Step::end; step = messages->next(m)) {
    if (step == Step::damaged) {
      report.lost.push_back(messages->fault());
    } else {
      writer.write(m.topic, m.log_time, m.publish_time, m.data);
    }
  }
  writer.close();
  report.messages = writer.message_count();
  report.size = writer.size();
  return report;
}

}  // namespace bw::bag
