#include "runtime/recording/bag/mcap_recover.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/recording/bag/compression.hpp"
#include "runtime/recording/bag/mcap_writer.hpp"

namespace bw::bag::mcap {
namespace {

constexpr std::uint64_t kWindow = std::uint64_t{1} << 20;  // of the search for the next chunk [bytes]

/// Walks over the file and copies; behind damage it looks for the next chunk.
class Recovery {
 public:
  Recovery(const ByteSource& file, Writer& writer) : file_(file), writer_(writer) {}

  RecoveryReport run(std::uint64_t offset) {
    Fault fault;
    while (offset < file_.size()) {
      Opcode opcode{};
      bool fine = read_record(file_, offset, opcode, content_, fault);
      const std::uint64_t length = kRecordPrefix + content_.size();
      if (fine && (opcode == Opcode::data_end || opcode == Opcode::footer)) break;
      fine = fine && take(opcode, offset, fault);
      if (fine) {
        offset += length;
        continue;
      }
      const std::uint64_t next = next_chunk(offset + 1);
      report_.faults.push_back(fault);
      report_.lost_bytes += next - offset;
      offset = next;
    }
    writer_.close();
    report_.messages = writer_.statistics().message_count;
    return std::move(report_);
  }

 private:
  bool take(Opcode opcode, std::uint64_t offset, Fault& fault) {
    fault = {offset, "a record does not hold what it should"};
    if (opcode == Opcode::chunk) {
      Chunk chunk;
      return open_chunk(content_, offset, chunk, records_, fault) && take_records(fault);
    }
    if (opcode == Opcode::attachment) {
      Attachment attachment;
      bool crc_fits = false;
      if (!parse(content_, attachment, crc_fits) || !crc_fits) return false;
      writer_.write(attachment);
      return true;
    }
    if (opcode == Opcode::metadata) {
      Metadata metadata;
      if (!parse(content_, metadata)) return false;
      writer_.write(metadata);
      return true;
    }
    return take_record({opcode, 0, content_});
  }

  bool take_records(Fault& fault) {
    fault.what = "a record in the chunk does not hold what it should";
    std::size_t offset = 0;
    RecordView record;
    while (offset < records_.size()) {
      if (!next_record(records_, offset, record) || !take_record(record)) return false;
    }
    return true;
  }

  bool take_record(const RecordView& record) {
    if (record.opcode == Opcode::schema) {
      Schema schema;
      if (!parse(record.content, schema)) return false;
      const auto [known, is_new] = schemas_.emplace(schema.id, schema);
      if (is_new) writer_.add_schema(schema);
      return known->second == schema;
    }
    if (record.opcode == Opcode::channel) {
      Channel channel;
      if (!parse(record.content, channel)) return false;
      if (channel.schema_id != 0 && !schemas_.contains(channel.schema_id)) return false;
      const auto [known, is_new] = channels_.emplace(channel.id, channel);
      if (is_new) writer_.add_channel(channel);
      return known->second == channel;
    }
    if (record.opcode != Opcode::message) return true;  // indexes are made anew
    Message message;
    if (!parse(record.content, message) || !channels_.contains(message.channel_id)) return false;
    writer_.write(message);
    return true;
  }

  /// Where, from `offset` on, a chunk begins whose checksum fits; the end of the file if none does.
  std::uint64_t next_chunk(std::uint64_t offset) {
    Bytes window;
    while (offset < file_.size()) {
      const std::uint64_t size = std::min(kWindow, file_.size() - offset);
      if (!file_.read(offset, size, window)) return file_.size();
      const auto begin = window.begin();
      for (auto at = std::find(begin, window.end(), std::uint8_t{6}); at != window.end();
           at = std::find(at + 1, window.end(), std::uint8_t{6})) {
        const std::uint64_t candidate = offset + static_cast<std::uint64_t>(at - begin);
        if (is_chunk(candidate)) return candidate;
      }
      offset += size;
    }
    return file_.size();
  }

  bool is_chunk(std::uint64_t offset) {
    // Two times, size and checksum are 28 bytes; then comes the name of the compression: "", lz4 or zstd.
    Bytes head;
    if (!file_.read(offset + kRecordPrefix, 32, head)) return false;
    ByteReader reader(BytesView(head).subspan(28));
    std::uint32_t name_length = 0;
    if (!reader.number(name_length) || (name_length != 0 && name_length != 3 && name_length != 4))
      return false;
    Opcode opcode{};
    Fault fault;
    Chunk chunk;
    return read_record(file_, offset, opcode, content_, fault) &&
           open_chunk(content_, offset, chunk, records_, fault) && chunk.uncompressed_crc != 0;
  }

  const ByteSource& file_;
  Writer& writer_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  Bytes content_;
  Bytes records_;
  RecoveryReport report_;
};

}  // namespace

RecoveryReport recover(const std::filesystem::path& from, const std::filesystem::path& to) {
  const ByteSource file(from);
  const Contents contents = read_contents(file);
  WriterOptions options{.compression = Compression::none, .profile = contents.header.profile};
  for (const ChunkIndex& chunk : contents.chunks) {
    options.compression =
        std::max(options.compression, compression_of(chunk.compression).value_or(Compression::none));
  }
  Writer writer(create_file(to), options);
  RecoveryReport report = Recovery(file, writer).run(kMagic.size());
  if (!contents.from_summary) report.faults.insert(report.faults.begin(), contents.faults.front());
  report.was_whole = report.faults.empty();
  return report;
}

}  // namespace bw::bag::mcap
