#include "runtime/recording/bag/mcap_bag.hpp"

#include <algorithm>
#include <utility>

#include "runtime/recording/bag/byte_source.hpp"
#include "runtime/recording/bag/mcap_messages.hpp"
#include "runtime/recording/bag/mcap_time.hpp"
#include "runtime/recording/bag/mcap_verify.hpp"

namespace bw::bag {
namespace {

class McapMessages final : public BagMessages {
 public:
  McapMessages(const ByteSource& file, const mcap::Contents& contents, mcap::Selection selection,
               const std::map<std::uint16_t, std::size_t>& topic_of)
      : file_(file), topic_of_(topic_of), messages_(file, contents, std::move(selection)) {}

  Step next(BagMessage& message) override {
    mcap::Message read;
    const mcap::Step step = messages_.next(read);
    if (step != mcap::Step::message) return step == mcap::Step::end ? Step::end : Step::damaged;
    message = {.topic = topic_of_.at(read.channel_id),
               .log_time = from_mcap_time(read.log_time),
               .publish_time = from_mcap_time(read.publish_time),
               .data = read.data};
    return Step::message;
  }
  BagFault fault() const override { return {file_.path(), messages_.fault().offset, messages_.fault().what}; }

 private:
  const ByteSource& file_;
  const std::map<std::uint16_t, std::size_t>& topic_of_;
  mcap::Messages messages_;
};

class McapBag final : public Bag {
 public:
  explicit McapBag(const std::filesystem::path& path) : file_(path), contents_(mcap::read_contents(file_)) {
    for (const auto& [id, channel] : contents_.channels) {
      // Several publishers of one topic may have channels of their own.
      const auto schema = contents_.schemas.find(channel.schema_id);
      BagTopic topic{.name = channel.topic, .serialization_format = channel.message_encoding};
      if (schema != contents_.schemas.end()) {
        topic.type = schema->second.name;
        topic.schema_encoding = schema->second.encoding;
        topic.schema_text.assign(schema->second.data.begin(), schema->second.data.end());
      }
      const auto text = [&](const char* key) {
        const auto found = channel.metadata.find(key);
        return found == channel.metadata.end() ? std::string() : found->second;
      };
      topic.offered_qos_profiles = text("offered_qos_profiles");
      topic.type_hash = text("topic_type_hash");
      topic.writer = text("node");
      const auto same =
          std::ranges::find_if(topics_, [&](const BagTopic& t) { return is_same_topic(t, topic); });
      topic_of_[id] = static_cast<std::size_t>(same - topics_.begin());
      if (same == topics_.end()) topics_.push_back(std::move(topic));
      const auto& counts = contents_.statistics.channel_message_counts;
      if (const auto count = counts.find(id); count != counts.end()) {
        topics_[topic_of_[id]].message_count += count->second;
      }
    }
    for (const mcap::Fault& fault : contents_.faults) faults_.push_back({path, fault.offset, fault.what});
  }

  std::string storage() const override { return "mcap"; }
  std::string profile() const override { return contents_.header.profile; }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  Time start() const override { return from_mcap_time(contents_.statistics.start_time); }
  Time end() const override { return from_mcap_time(contents_.statistics.end_time); }
  std::uint64_t message_count() const override { return contents_.statistics.message_count; }
  const std::vector<BagFault>& faults() const override { return faults_; }

  std::vector<BagAttachment> attachments() const override {
    std::vector<BagAttachment> all;
    for (const mcap::AttachmentIndex& a : contents_.attachments)
      all.push_back({a.name, a.media_type, a.data_size, file_.path(), a.offset});
    return all;
  }
  std::optional<Bytes> attachment(const std::string& name) const override {
    for (const mcap::AttachmentIndex& index : contents_.attachments) {
      mcap::Opcode opcode{};
      mcap::Fault fault;
      Bytes content;
      mcap::Attachment found;
      bool crc_fits = false;
      if (index.name == name && mcap::read_record(file_, index.offset, opcode, content, fault) &&
          opcode == mcap::Opcode::attachment && mcap::parse(content, found, crc_fits) && crc_fits) {
        return std::move(found.data);
      }
    }
    return std::nullopt;
  }
  std::map<std::string, std::map<std::string, std::string>> metadata() const override {
    std::map<std::string, std::map<std::string, std::string>> all;
    for (const mcap::MetadataIndex& index : contents_.metadata) {
      mcap::Opcode opcode{};
      mcap::Fault fault;
      Bytes content;
      mcap::Metadata record;
      if (mcap::read_record(file_, index.offset, opcode, content, fault) &&
          opcode == mcap::Opcode::metadata && mcap::parse(content, record)) {
        all[record.name] = std::move(record.entries);  // the last one counts
      }
    }
    return all;
  }
  std::vector<BagFault> verify() const override {
    std::vector<BagFault> faults;
    for (const mcap::Fault& fault : mcap::verify(file_, contents_))
      faults.push_back({file_.path(), fault.offset, fault.what});
    return faults;
  }
  std::unique_ptr<BagMessages> messages(const BagSelection& selection) const override {
    mcap::Selection wanted{.start = to_mcap_time(selection.start)};
    if (selection.end != BagSelection{}.end) wanted.end = to_mcap_time(selection.end);
    if (selection.topics) {
      wanted.channels.emplace();
      for (const auto& [id, topic] : topic_of_) {
        if (selection.topics->contains(topics_[topic].name)) wanted.channels->insert(id);
      }
    }
    return std::make_unique<McapMessages>(file_, contents_, std::move(wanted), topic_of_);
  }

 private:
  ByteSource file_;
  mcap::Contents contents_;
  std::vector<BagTopic> topics_;
  std::map<std::uint16_t, std::size_t> topic_of_;  ///< by channel
  std::vector<BagFault> faults_;
};

}  // namespace

std::unique_ptr<Bag> open_mcap_file(const std::filesystem::path& file) {
  return std::make_unique<McapBag>(file);
}

}  // namespace bw::bag
