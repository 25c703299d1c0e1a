#include "runtime/recording/bag/mcap_records.hpp"

#include <zlib.h>

namespace bw::bag::mcap {
namespace {

/// Writes prefix and content; the length is filled in at the end.
class RecordWriter {
 public:
  RecordWriter(Bytes& out, Opcode opcode) : out_(out), start_(out.size()), bytes(out) {
    bytes.number(static_cast<std::uint8_t>(opcode));
    bytes.number(std::uint64_t{0});
  }
  ~RecordWriter() { bytes.overwrite(start_ + 1, std::uint64_t{out_.size() - start_ - kRecordPrefix}); }
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

 private:
  Bytes& out_;
  std::size_t start_;

 public:
  ByteWriter bytes;
};

}  // namespace

void append(Bytes& out, const Header& record) {
  RecordWriter w(out, Opcode::header);
  w.bytes.text(record.profile);
  w.bytes.text(record.library);
}

void append(Bytes& out, const Footer& record) {
  RecordWriter w(out, Opcode::footer);
  w.bytes.number(record.summary_start);
  w.bytes.number(record.summary_offset_start);
  w.bytes.number(record.summary_crc);
}

void append(Bytes& out, const Schema& record) {
  RecordWriter w(out, Opcode::schema);
  w.bytes.number(record.id);
  w.bytes.text(record.name);
  w.bytes.text(record.encoding);
  w.bytes.number(static_cast<std::uint32_t>(record.data.size()));
  w.bytes.raw(record.data);
}

void append(Bytes& out, const Channel& record) {
  RecordWriter w(out, Opcode::channel);
  w.bytes.number(record.id);
  w.bytes.number(record.schema_id);
  w.bytes.text(record.topic);
  w.bytes.text(record.message_encoding);
  w.bytes.map(record.metadata);
}

void append(Bytes& out, const Message& record) {
  RecordWriter w(out, Opcode::message);
  w.bytes.number(record.channel_id);
  w.bytes.number(record.sequence);
  w.bytes.number(record.log_time);
  w.bytes.number(record.publish_time);
  w.bytes.raw(record.data);
}

void append(Bytes& out, const Chunk& record) {
  RecordWriter w(out, Opcode::chunk);
  w.bytes.number(record.start_time);
  w.bytes.number(record.end_time);
  w.bytes.number(record.uncompressed_size);
  w.bytes.number(record.uncompressed_crc);
  w.bytes.text(record.compression);
  w.bytes.number(std::uint64_t{record.records.size()});
  w.bytes.raw(record.records);
}

void append(Bytes& out, const MessageIndex& record) {
  RecordWriter w(out, Opcode::message_index);
  w.bytes.number(record.channel_id);
  const std::size_t start = w.bytes.begin_array();
  for (const auto& [time, offset] : record.entries) {
    w.bytes.number(time);
    w.bytes.number(offset);
  }
  w.bytes.end_array(start);
}

void append(Bytes& out, const ChunkIndex& record) {
  RecordWriter w(out, Opcode::chunk_index);
  w.bytes.number(record.start_time);
  w.bytes.number(record.end_time);
  w.bytes.number(record.chunk_start);
  w.bytes.number(record.chunk_length);
  const std::size_t start = w.bytes.begin_array();
  for (const auto& [channel, offset] : record.message_index_offsets) {
    w.bytes.number(channel);
    w.bytes.number(offset);
  }
  w.bytes.end_array(start);
  w.bytes.number(record.message_index_length);
  w.bytes.text(record.compression);
  w.bytes.number(record.compressed_size);
  w.bytes.number(record.uncompressed_size);
}

void append(Bytes& out, const Attachment& record) {
  const std::size_t start = out.size() + kRecordPrefix;
  RecordWriter w(out, Opcode::attachment);
  w.bytes.number(record.log_time);
  w.bytes.number(record.create_time);
  w.bytes.text(record.name);
  w.bytes.text(record.media_type);
  w.bytes.number(std::uint64_t{record.data.size()});
  w.bytes.raw(record.data);
  w.bytes.number(crc32(BytesView(out).subspan(start)));
}

void append(Bytes& out, const AttachmentIndex& record) {
  RecordWriter w(out, Opcode::attachment_index);
  w.bytes.number(record.offset);
  w.bytes.number(record.length);
  w.bytes.number(record.log_time);
  w.bytes.number(record.create_time);
  w.bytes.number(record.data_size);
  w.bytes.text(record.name);
  w.bytes.text(record.media_type);
}

void append(Bytes& out, const Statistics& record) {
  RecordWriter w(out, Opcode::statistics);
  w.bytes.number(record.message_count);
  w.bytes.number(record.schema_count);
  w.bytes.number(record.channel_count);
  w.bytes.number(record.attachment_count);
  w.bytes.number(record.metadata_count);
  w.bytes.number(record.chunk_count);
  w.bytes.number(record.start_time);
  w.bytes.number(record.end_time);
  const std::size_t start = w.bytes.begin_array();
  for (const auto& [channel, count] : record.channel_message_counts) {
    w.bytes.number(channel);
    w.bytes.number(count);
  }
  w.bytes.end_array(start);
}

void append(Bytes& out, const Metadata& record) {
  RecordWriter w(out, Opcode::metadata);
  w.bytes.text(record.name);
  w.bytes.map(record.entries);
}

void append(Bytes& out, const MetadataIndex& record) {
  RecordWriter w(out, Opcode::metadata_index);
  w.bytes.number(record.offset);
  w.bytes.number(record.length);
  w.bytes.text(record.name);
}

void append(Bytes& out, const SummaryOffset& record) {
  RecordWriter w(out, Opcode::summary_offset);
  w.bytes.number(record.group_opcode);
  w.bytes.number(record.group_start);
  w.bytes.number(record.group_length);
}

void append_data_end(Bytes& out, std::uint32_t data_section_crc) {
  RecordWriter w(out, Opcode::data_end);
  w.bytes.number(data_section_crc);
}

bool parse(BytesView content, Header& record) {
  ByteReader r(content);
  return r.text(record.profile) && r.text(record.library);
}

bool parse(BytesView content, Footer& record) {
  ByteReader r(content);
  return r.number(record.summary_start) && r.number(record.summary_offset_start) &&
         r.number(record.summary_crc);
}

bool parse(BytesView content, Schema& record) {
  ByteReader r(content);
  std::uint32_t size = 0;
  BytesView data;
  if (!(r.number(record.id) && r.text(record.name) && r.text(record.encoding) && r.number(size) &&
        r.raw(size, data))) {
    return false;
  }
  record.data.assign(data.begin(), data.end());
  return record.id != 0;
}

bool parse(BytesView content, Channel& record) {
  ByteReader r(content);
  return r.number(record.id) && r.number(record.schema_id) && r.text(record.topic) &&
         r.text(record.message_encoding) && r.map(record.metadata);
}

bool parse(BytesView content, Message& record) {
  ByteReader r(content);
  return r.number(record.channel_id) && r.number(record.sequence) && r.number(record.log_time) &&
         r.number(record.publish_time) && r.raw(r.remaining(), record.data);
}

bool parse(BytesView content, Chunk& record) {
  ByteReader r(content);
  std::uint64_t size = 0;
  return r.number(record.start_time) && r.number(record.end_time) && r.number(record.uncompressed_size) &&
         r.number(record.uncompressed_crc) && r.text(record.compression) && r.number(size) &&
         r.raw(size, record.records);
}

bool parse(BytesView content, ChunkIndex& record) {
  ByteReader r(content);
  ByteReader offsets({});
  if (!(r.number(record.start_time) && r.number(record.end_time) && r.number(record.chunk_start) &&
        r.number(record.chunk_length) && r.array(offsets))) {
    return false;
  }
  while (offsets.remaining() > 0) {
    std::uint16_t channel = 0;
    std::uint64_t offset = 0;
    if (!offsets.number(channel) || !offsets.number(offset)) return false;
    record.message_index_offsets.emplace_back(channel, offset);
  }
  return r.number(record.message_index_length) && r.text(record.compression) &&
         r.number(record.compressed_size) && r.number(record.uncompressed_size);
}

bool parse(BytesView content, Attachment& record, bool& crc_fits) {
  ByteReader r(content);
  std::uint64_t size = 0;
  BytesView data;
  if (!(r.number(record.log_time) && r.number(record.create_time) && r.text(record.name) &&
        r.text(record.media_type) && r.number(size) && r.raw(size, data))) {
    return false;
  }
  const std::size_t end = r.offset();
  std::uint32_t crc = 0;
  if (!r.number(crc)) return false;
  crc_fits = crc == 0 || crc == crc32(content.first(end));
  record.data.assign(data.begin(), data.end());
  return true;
}

bool parse(BytesView content, AttachmentIndex& record) {
  ByteReader r(content);
  return r.number(record.offset) && r.number(record.length) && r.number(record.log_time) &&
         r.number(record.create_time) && r.number(record.data_size) && r.text(record.name) &&
         r.text(record.media_type);
}

bool parse(BytesView content, Statistics& record) {
  ByteReader r(content);
  ByteReader counts({});
  if (!(r.number(record.message_count) && r.number(record.schema_count) && r.number(record.channel_count) &&
        r.number(record.attachment_count) && r.number(record.metadata_count) &&
        r.number(record.chunk_count) && r.number(record.start_time) && r.number(record.end_time) &&
        r.array(counts))) {
    return false;
  }
  while (counts.remaining() > 0) {
    std::uint16_t channel = 0;
    std::uint64_t count = 0;
    if (!counts.number(channel) || !counts.number(count)) return false;
    record.channel_message_counts[channel] = count;
  }
  return true;
}

bool parse(BytesView content, Metadata& record) {
  ByteReader r(content);
  return r.text(record.name) && r.map(record.entries);
}

bool parse(BytesView content, MetadataIndex& record) {
  ByteReader r(content);
  return r.number(record.offset) && r.number(record.length) && r.text(record.name);
}

bool next_record(BytesView records, std::size_t& offset, RecordView& record) {
  ByteReader r(records.subspan(offset));
  std::uint8_t opcode = 0;
  std::uint64_t length = 0;
  if (!r.number(opcode) || !r.number(length) || !r.raw(length, record.content)) return false;
  record.opcode = static_cast<Opcode>(opcode);
  record.offset = offset;
  offset += r.offset();
  return true;
}

std::uint32_t crc32(BytesView bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}

}  // namespace bw::bag::mcap
