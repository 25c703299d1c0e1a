#include "runtime/recording/bag/bag_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/atomic_file.hpp"
#include "runtime/recording/bag/mcap_time.hpp"
#include "runtime/recording/bag/qos_text.hpp"

namespace bw::bag {
namespace {

constexpr std::uint64_t kPartsOfMaxSize = 10;

/// Held as long as the folder is written; a kill lets go of it.
int lock_folder(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), folder.string());
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor);
    throw std::runtime_error(folder.string() + ": another recorder writes there");
  }
  return descriptor;
}

/// For its owner alone, as are those above it that are missing.
void make_folder(const std::filesystem::path& folder) {
  if (folder.empty() || std::filesystem::exists(folder)) return;
  make_folder(folder.parent_path());
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    throw std::system_error(errno, std::generic_category(), folder.string());
}

}  // namespace

BagWriter::BagWriter(std::filesystem::path path, BagWriterOptions options)
    : path_(std::move(path)), options_(std::move(options)), is_folder_(path_.extension() != ".mcap") {
  metadata_.ros_distro = options_.ros_distro;
  if (options_.max_size > 0 && options_.split_size == 0)
    options_.split_size = std::max<std::uint64_t>(options_.max_size / kPartsOfMaxSize, 1);
  if (!is_folder_) {
    make_folder(path_.parent_path());
    open_file();
    return;
  }
  make_folder(path_);
  path_ = std::filesystem::canonical(path_);
  lock_ = lock_folder(path_);
  if (!std::filesystem::is_empty(path_)) {
    ::close(lock_);
    throw std::runtime_error(path_.string() + " is not empty: a recording needs a folder of its own");
  }
  open_file();
}

BagWriter::~BagWriter() {
  if (lock_ >= 0) ::close(lock_);
}

std::filesystem::path BagWriter::file_path(std::size_t number) const {
  if (!is_folder_) return path_;
  return path_ / (path_.filename().string() + "_" + std::to_string(number) + ".mcap");
}

void BagWriter::open_file() {
  const std::filesystem::path file = file_path(next_number_++);
  file_ = std::make_unique<mcap::Writer>(
      options_.create(file),
      mcap::WriterOptions{.compression = options_.compression, .profile = options_.profile});
  for (const mcap::Schema& schema : schemas_) file_->add_schema(schema);
  for (const mcap::Channel& channel : channels_) file_->add_channel(channel);
  metadata_.files.push_back({.path = file.filename().string()});
  file_has_messages_ = false;
}

std::size_t BagWriter::add_topic(const BagTopic& topic) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  if (channels_.size() == kMax)
    throw std::runtime_error(path_.string() + ": MCAP has no room for more than 65535 topics");
  std::uint16_t& schema_id = schema_ids_[{topic.type, topic.schema_encoding + "\n" + topic.schema_text}];
  const bool has_schema = !topic.type.empty() || !topic.schema_text.empty();
  if (schema_id == 0 && has_schema) {
    schema_id = static_cast<std::uint16_t>(schemas_.size() + 1);
    schemas_.push_back({.id = schema_id,
                        .name = topic.type,
                        .encoding = topic.schema_encoding,
                        .data = {topic.schema_text.begin(), topic.schema_text.end()}});
    file_->add_schema(schemas_.back());
  }
  channels_.push_back({.id = static_cast<std::uint16_t>(channels_.size() + 1),
                       .schema_id = schema_id,
                       .topic = topic.name,
                       .message_encoding = topic.serialization_format,
                       .metadata = {{"offered_qos_profiles", topic.offered_qos_profiles},
                                    {"topic_type_hash", topic.type_hash}}});
  if (!topic.writer.empty()) channels_.back().metadata["node"] = topic.writer;
  file_->add_channel(channels_.back());
  topics_.push_back(topic);
  latched_depths_.push_back(latched_depth(from_qos_text(topic.offered_qos_profiles)));
  const auto listed = std::ranges::find_if(
      metadata_.topics, [&](const TopicMetadata& t) { return t.name == topic.name && t.type == topic.type; });
  listed_as_.push_back(static_cast<std::size_t>(listed - metadata_.topics.begin()));
  if (listed != metadata_.topics.end()) {
    listed->offered_qos_profiles += topic.offered_qos_profiles;
    return topics_.size() - 1;
  }
  metadata_.topics.push_back({.name = topic.name,
                              .type = topic.type,
                              .serialization_format = topic.serialization_format,
                              .offered_qos_profiles = topic.offered_qos_profiles,
                              .type_hash = topic.type_hash});
  return topics_.size() - 1;
}

void BagWriter::write(std::size_t topic, Time log_time, Time publish_time, BytesView data) {
  const bool too_large = options_.split_size > 0 && file_->size() > options_.split_size;
  const bool too_long =
      options_.split_duration > Duration{} && log_time - file_start_ > options_.split_duration;
  if (is_folder_ && file_has_messages_ && (too_large || too_long)) {
    close_file();
    open_file();
  }
  write_message(topic, log_time, publish_time, data);
  if (is_folder_ && options_.max_size > 0 && size() > options_.max_size) delete_oldest(log_time);
}

void BagWriter::write_message(std::size_t topic, Time log_time, Time publish_time, BytesView data) {
  file_->write({.channel_id = channels_[topic].id,
                .log_time = to_mcap_time(log_time),
                .publish_time = to_mcap_time(publish_time),
                .data = data});
  if (!std::exchange(file_has_messages_, true)) file_start_ = log_time;
  ++metadata_.topics[listed_as_[topic]].message_count;
  ++metadata_.message_count;
  if (options_.max_size == 0 || latched_depths_[topic] == 0) return;
  carried_.add(next_number_ - 1, Carried::Message{topic, log_time, publish_time, {data.begin(), data.end()}},
               latched_depths_[topic]);
}

void BagWriter::attach(const std::string& name, const std::string& media_type, std::string_view content,
                       Time now) {
  file_->write(mcap::Attachment{.log_time = to_mcap_time(now),
                                .create_time = 0,
                                .name = name,
                                .media_type = media_type,
                                .data = {content.begin(), content.end()}});
  if (options_.max_size > 0)
    carried_.add(next_number_ - 1, Carried::Attachment{name, media_type, std::string(content), now});
}

void BagWriter::add_metadata(const std::string& name, const std::map<std::string, std::string>& entries) {
  file_->write(mcap::Metadata{.name = name, .entries = entries});
  if (options_.max_size > 0) carried_.add(next_number_ - 1, Carried::Metadata{name, entries});
}

void BagWriter::flush() { file_->flush(); }

std::uint64_t BagWriter::size() const {
  std::uint64_t sum = file_ ? file_->size() : 0;
  for (const Closed& file : closed_) sum += file.size;
  return sum;
}

void BagWriter::close_file() {
  const mcap::Statistics& s = file_->statistics();
  FileMetadata& file = metadata_.files.back();
  file.start = s.start_time;
  file.duration = s.end_time - s.start_time;
  file.message_count = s.message_count;
  span_files();
  file_->write(mcap::Metadata{.name = "rosbag2", .entries = {{"serialized_metadata", to_record(metadata_)}}});
  file_->close();
  options_.sync(file_->sink());
  closed_.push_back({next_number_ - 1, file_->size(), s.channel_message_counts});
  file_.reset();
}

void BagWriter::span_files() {
  std::uint64_t end = 0;
  metadata_.start = 0;
  for (const FileMetadata& file : metadata_.files) {
    if (file.message_count == 0) continue;
    metadata_.start = end == 0 ? file.start : std::min(metadata_.start, file.start);
    end = std::max(end, file.start + file.duration);
  }
  metadata_.duration = end - metadata_.start;
}

void BagWriter::delete_oldest(Time now) {
  while (!closed_.empty() && size() > options_.max_size) {
    const Closed oldest = std::move(closed_.front());
    closed_.erase(closed_.begin());
    std::filesystem::remove(path_ / metadata_.files.front().path);
    metadata_.message_count -= metadata_.files.front().message_count;
    for (const auto& [channel, count] : oldest.counts)
      metadata_.topics[listed_as_[channel - 1U]].message_count -= count;
    metadata_.files.erase(metadata_.files.begin());
    const Carried::Parts parts = carried_.take(oldest.number);
    for (const auto& a : parts.attachments) attach(a.name, a.media_type, a.content, a.time);
    for (const auto& m : parts.metadata) add_metadata(m.name, m.entries);
    for (const auto& m : parts.messages) write_message(m.topic, now, m.publish_time, m.data);
  }
}

void BagWriter::close() {
  if (!file_) return;
  close_file();
  if (is_folder_) write_file_atomically(path_ / "metadata.yaml", to_yaml(metadata_));
}

}  // namespace bw::bag
