#include "runtime/recording/replay/updated_bag.hpp"

#include <string_view>

#include "runtime/build_identity.hpp"

namespace bw::replay {

std::filesystem::path beside(const std::filesystem::path& recording) {
  std::filesystem::path path = recording;
  if (!path.has_filename()) path = path.parent_path();  // drive/
  const bool is_file = path.extension() == ".mcap" || path.extension() == ".db3";
  path.replace_filename((is_file ? path.stem() : path.filename()).string() + ".replayed" +
                        (is_file ? ".mcap" : ""));
  return path;
}

UpdatedBag::UpdatedBag(const bag::Bag& recording, const std::filesystem::path& path)
    : recording_(recording), writer_(path, {.ros_distro = bag::ros_distro_in(recording.metadata())}) {
  for (const bag::BagTopic& topic : recording.topics()) writer_.add_topic(topic);
}

void UpdatedBag::write(std::size_t topic, Time log_time, Time publish_time, bag::BytesView cdr) {
  writer_.write(topic, log_time, publish_time, cdr);
}

void UpdatedBag::finish(const std::string& parameters) {
  const Time start = recording_.start();
  for (const bag::BagAttachment& a : recording_.attachments()) {
    const auto content = recording_.attachment(a.name);
    if (!content) continue;
    writer_.attach(a.name, a.media_type, {reinterpret_cast<const char*>(content->data()), content->size()},
                   start);
  }
  writer_.attach("replayed_parameters.yaml", "application/yaml", parameters, start);
  auto metadata = recording_.metadata();
  std::map<std::string, std::string>& made_by = metadata["bandwagon"];
  made_by["build_id"] = build_id();
  made_by["cpu"] = cpu_type();
  made_by["host"] = host_name();
  made_by["clock"] = "lockstep";
  made_by.erase("version");
  made_by.erase("revision");
  metadata["result"] = {{"messages_of_run", std::to_string(writer_.message_count())}};
  for (const auto& [name, entries] : metadata) {
    if (name != "rosbag2") writer_.add_metadata(name, entries);
  }
  writer_.close();
}

}  // namespace bw::replay
