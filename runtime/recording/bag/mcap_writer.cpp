#include "runtime/recording/bag/mcap_writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bw::bag::mcap {
namespace {

constexpr std::size_t kLeastCompressed =
    1024;                            // [bytes] of a chunk below which compression is not worth a frame
constexpr double kLeastGain = 0.02;  // share that compression must save

}  // namespace

Writer::Writer(std::shared_ptr<ByteSink> sink, WriterOptions options)
    : options_(std::move(options)), sink_(std::move(sink)) {
  Bytes start(kMagic.begin(), kMagic.end());
  append(start, Header{options_.profile, options_.library});
  put(start);
}

void Writer::put(BytesView bytes) {
  data_crc_ = crc32(bytes, data_crc_);
  sink_->write(bytes);
}

void Writer::add_schema(Schema schema) {
  const std::uint16_t id = schema.id;
  if (id == 0 || !schemas_.emplace(id, std::move(schema)).second)
    throw std::logic_error("a schema id twice, or 0");
}

void Writer::add_channel(Channel channel) {
  const std::uint16_t id = channel.id;
  if (channel.schema_id != 0 && !schemas_.contains(channel.schema_id)) {
    throw std::logic_error("channel " + channel.topic + " names a schema that was not added");
  }
  if (id == 0 || !channels_.emplace(id, std::move(channel)).second)
    throw std::logic_error("a channel id twice, or 0");
}

void Writer::declare_in_chunk(std::uint16_t channel_id) {
  if (chunk_messages_.contains(channel_id)) return;
  const auto channel = channels_.find(channel_id);
  if (channel == channels_.end()) throw std::logic_error("a message of a channel that was not added");
  chunk_messages_[channel_id].channel_id = channel_id;
  const std::uint16_t schema_id = channel->second.schema_id;
  if (schema_id != 0 && !std::exchange(chunk_schemas_[schema_id], true))
    append(chunk_, schemas_.at(schema_id));
  append(chunk_, channel->second);
}

void Writer::write(const Message& message) {
  const std::uint64_t size = message.data.size() + kRecordPrefix + 22;
  const bool too_large = chunk_.size() + size > options_.chunk_size;
  const bool too_long = chunk_has_messages_ &&
                        std::max(chunk_end_, message.log_time) - std::min(chunk_start_, message.log_time) >
                            options_.chunk_duration;
  if (chunk_has_messages_ && (too_large || too_long)) flush();
  declare_in_chunk(message.channel_id);
  chunk_messages_[message.channel_id].entries.emplace_back(message.log_time, chunk_.size());
  append(chunk_, message);

  chunk_start_ = chunk_has_messages_ ? std::min(chunk_start_, message.log_time) : message.log_time;
  chunk_end_ = chunk_has_messages_ ? std::max(chunk_end_, message.log_time) : message.log_time;
  chunk_has_messages_ = true;
  Statistics& s = statistics_;
  s.start_time = s.message_count == 0 ? message.log_time : std::min(s.start_time, message.log_time);
  s.end_time = std::max(s.end_time, message.log_time);
  ++s.message_count;
  ++s.channel_message_counts[message.channel_id];
}

void Writer::flush() {
  if (chunk_.empty()) return;
  Chunk chunk{.start_time = chunk_start_,
              .end_time = chunk_end_,
              .uncompressed_size = chunk_.size(),
              .uncompressed_crc = crc32(chunk_),
              .compression = {},
              .records = chunk_};
  if (options_.compression != Compression::none && chunk_.size() >= kLeastCompressed) {
    compress(options_.compression, chunk_, compressed_);
    if (static_cast<double>(compressed_.size()) <= (1.0 - kLeastGain) * static_cast<double>(chunk_.size())) {
      chunk.compression = name_of(options_.compression);
      chunk.records = compressed_;
    }
  }
  ChunkIndex index{.start_time = chunk.start_time,
                   .end_time = chunk.end_time,
                   .chunk_start = sink_->size(),
                   .compression = chunk.compression,
                   .compressed_size = chunk.records.size(),
                   .uncompressed_size = chunk.uncompressed_size};
  record_.clear();
  append(record_, chunk);
  index.chunk_length = record_.size();
  write_message_indexes(index);
  // In one write: a reader never meets a chunk without its indexes.
  put(record_);
  chunk_indexes_.push_back(std::move(index));
  ++statistics_.chunk_count;
  chunk_.clear();
  chunk_messages_.clear();
  chunk_schemas_.clear();
  chunk_has_messages_ = false;
}

void Writer::write_message_indexes(ChunkIndex& index) {
  const std::size_t start = record_.size();
  for (const auto& [channel, messages] : chunk_messages_) {
    index.message_index_offsets.emplace_back(channel, index.chunk_start + record_.size());
    append(record_, messages);
  }
  index.message_index_length = record_.size() - start;
}

void Writer::write(const Attachment& attachment) {
  flush();
  record_.clear();
  append(record_, attachment);
  attachment_indexes_.push_back({.offset = sink_->size(),
                                 .length = record_.size(),
                                 .log_time = attachment.log_time,
                                 .create_time = attachment.create_time,
                                 .data_size = attachment.data.size(),
                                 .name = attachment.name,
                                 .media_type = attachment.media_type});
  put(record_);
  ++statistics_.attachment_count;
}

void Writer::write(const Metadata& metadata) {
  flush();
  record_.clear();
  append(record_, metadata);
  metadata_indexes_.push_back({.offset = sink_->size(), .length = record_.size(), .name = metadata.name});
  put(record_);
  ++statistics_.metadata_count;
}

void Writer::append_summary(Bytes& out, std::uint64_t start) {
  std::vector<SummaryOffset> groups;
  const auto group = [&](Opcode opcode, const auto& append_all) {
    const std::size_t begin = out.size();
    append_all();
    if (out.size() > begin) {
      groups.push_back({static_cast<std::uint8_t>(opcode), start + begin, std::uint64_t{out.size() - begin}});
    }
  };
  group(Opcode::schema, [&] {
    for (const auto& [id, schema] : schemas_) append(out, schema);
  });
  group(Opcode::channel, [&] {
    for (const auto& [id, channel] : channels_) append(out, channel);
  });
  group(Opcode::statistics, [&] { append(out, statistics_); });
  group(Opcode::chunk_index, [&] {
    for (const ChunkIndex& index : chunk_indexes_) append(out, index);
  });
  group(Opcode::attachment_index, [&] {
    for (const AttachmentIndex& index : attachment_indexes_) append(out, index);
  });
  group(Opcode::metadata_index, [&] {
    for (const MetadataIndex& index : metadata_indexes_) append(out, index);
  });
  Footer footer{.summary_start = start, .summary_offset_start = start + out.size()};
  for (const SummaryOffset& offset : groups) append(out, offset);
  // The CRC covers the footer up to the CRC itself.
  append(out, footer);
  const std::size_t crc_at = out.size() - sizeof(std::uint32_t);
  ByteWriter(out).overwrite(crc_at, crc32(BytesView(out).first(crc_at)));
}

void Writer::close() {
  flush();
  statistics_.schema_count = static_cast<std::uint16_t>(schemas_.size());
  statistics_.channel_count = static_cast<std::uint32_t>(channels_.size());
  Bytes end;
  append_data_end(end, data_crc_);
  const std::uint64_t summary_start = sink_->size() + end.size();
  Bytes summary;
  append_summary(summary, summary_start);
  ByteWriter(end).raw(summary);
  ByteWriter(end).raw(BytesView(kMagic));
  sink_->write(end);
}

}  // namespace bw::bag::mcap
