#include "runtime/recording/bag/mcap_contents.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "runtime/recording/bag/compression.hpp"

namespace bw::bag::mcap {
namespace {

constexpr std::uint64_t kEnd = kRecordPrefix + kFooterLength + kMagic.size();  // footer and magic [bytes]

bool is_magic(BytesView bytes) { return std::ranges::equal(bytes, kMagic); }

/// The same id must always mean the same.
template <class T>
bool keep(std::map<std::uint16_t, T>& all, const T& record) {
  const auto [known, is_new] = all.emplace(record.id, record);
  return is_new || known->second == record;
}

/// Adds what a summary says of the file to `contents`; false when it does not parse.
bool read_group(BytesView summary, Contents& contents) {
  std::size_t offset = 0;
  RecordView record;
  while (offset < summary.size()) {
    if (!next_record(summary, offset, record)) return false;
    const auto parsed_into = [&](auto& list) { return parse(record.content, list.emplace_back()); };
    bool fine = true;
    Schema schema;
    Channel channel;
    switch (record.opcode) {
      case Opcode::schema:
        fine = parse(record.content, schema) && keep(contents.schemas, schema);
        break;
      case Opcode::channel:
        fine = parse(record.content, channel) && keep(contents.channels, channel);
        break;
      case Opcode::statistics:
        fine = parse(record.content, contents.statistics);
        break;
      case Opcode::chunk_index:
        fine = parsed_into(contents.chunks);
        break;
      case Opcode::attachment_index:
        fine = parsed_into(contents.attachments);
        break;
      case Opcode::metadata_index:
        fine = parsed_into(contents.metadata);
        break;
      default:
        break;
    }
    if (!fine) return false;
  }
  return true;
}

/// What the summary promises must lie in the file before it.
bool is_within(const Contents& contents, std::uint64_t summary_start) {
  const auto inside = [&](std::uint64_t offset, std::uint64_t length) {
    return offset <= summary_start && length <= summary_start - offset && length > kRecordPrefix;
  };
  return std::ranges::all_of(contents.chunks,
                             [&](const auto& c) { return inside(c.chunk_start, c.chunk_length); }) &&
         std::ranges::all_of(contents.attachments,
                             [&](const auto& a) { return inside(a.offset, a.length); }) &&
         std::ranges::all_of(contents.metadata, [&](const auto& m) { return inside(m.offset, m.length); });
}

/// One chunk named a thousand times would be read a thousand times.
bool is_apart(const std::vector<ChunkIndex>& chunks) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> extents;
  for (const ChunkIndex& c : chunks) extents.emplace_back(c.chunk_start, c.chunk_length);
  std::ranges::sort(extents);
  return std::ranges::adjacent_find(extents, [](const auto& a, const auto& b) {
           return b.first - a.first < a.second;
         }) == extents.end();
}

/// Nothing, with a fault, when the file has no summary that can be trusted.
std::optional<Contents> from_summary(const ByteSource& file, Fault& fault) {
  Bytes end;
  const std::uint64_t footer_at = file.size() - std::min(file.size(), kEnd);
  Footer footer;
  Bytes summary;
  fault = {file.size(), "the end is missing: the file was not closed"};
  if (!file.read(footer_at, kEnd, end) || !is_magic(BytesView(end).last(kMagic.size()))) return std::nullopt;
  fault = {footer_at, "the footer is none"};
  if (end[0] != static_cast<std::uint8_t>(Opcode::footer) ||
      !parse(BytesView(end).subspan(kRecordPrefix, kFooterLength), footer)) {
    return std::nullopt;
  }
  fault = {footer_at, "there is no summary"};
  if (footer.summary_start == 0) return std::nullopt;
  fault = {footer_at, "the footer names a summary that does not lie before it"};
  const std::uint64_t offsets = footer.summary_offset_start == 0 ? footer_at : footer.summary_offset_start;
  if (footer.summary_start > offsets || offsets > footer_at) return std::nullopt;
  fault = {footer_at,
           "the footer names a summary of " + std::to_string(footer_at - footer.summary_start) + " bytes"};
  if (footer_at - footer.summary_start > kLargestRecord) return std::nullopt;
  if (!file.read(footer.summary_start, footer_at - footer.summary_start, summary)) return std::nullopt;
  fault = {footer.summary_start, "the checksum of the summary does not fit"};
  const std::uint32_t crc = crc32(BytesView(end).first(kRecordPrefix + kFooterLength - 4), crc32(summary));
  if (footer.summary_crc != 0 && footer.summary_crc != crc) return std::nullopt;
  fault = {footer.summary_start, "the summary does not hold what a summary holds"};
  Contents contents;
  const auto size = static_cast<std::size_t>(offsets - footer.summary_start);
  if (!read_group(BytesView(summary).first(size), contents)) return std::nullopt;
  fault = {footer.summary_start, "the summary names places that are not in the file"};
  if (!is_within(contents, footer.summary_start)) return std::nullopt;
  fault = {footer.summary_start, "the summary names chunks that lie in each other"};
  if (!is_apart(contents.chunks)) return std::nullopt;
  fault = {footer.summary_start, "messages outside of chunks are in no summary"};
  if (contents.chunks.empty() && contents.statistics.message_count > 0) return std::nullopt;
  contents.summary_start = footer.summary_start;
  contents.from_summary = true;
  return contents;
}

void count(const Message& message, Statistics& s) {
  s.start_time = s.message_count == 0 ? message.log_time : std::min(s.start_time, message.log_time);
  s.end_time = std::max(s.end_time, message.log_time);
  ++s.message_count;
  ++s.channel_message_counts[message.channel_id];
}

/// Walks over the file from record to record.
class Walk {
 public:
  Walk(const ByteSource& file, Contents& contents) : file_(file), contents_(contents) {}

  void run() {
    std::uint64_t offset = kMagic.size();
    Fault fault;
    while (offset < file_.size()) {
      Opcode opcode{};
      if (!read_record(file_, offset, opcode, content_, fault)) {
        // What a recorder that was killed leaves behind is no damage of anything before it.
        contents_.faults.push_back(std::move(fault));
        return;
      }
      const std::uint64_t length = kRecordPrefix + content_.size();
      if (opcode == Opcode::data_end || opcode == Opcode::footer) return;
      if (!take(opcode, offset, length, fault)) {
        contents_.faults.push_back(std::move(fault));
        if (opcode != Opcode::chunk) return;
      }
      offset += length;
    }
  }

 private:
  bool take(Opcode opcode, std::uint64_t offset, std::uint64_t length, Fault& fault) {
    fault = {offset, "a record does not hold what it should"};
    Statistics& s = contents_.statistics;
    switch (opcode) {
      case Opcode::schema:
      case Opcode::channel:
        return take_declaration(opcode, content_, offset, fault);
      case Opcode::message: {
        Message message;
        if (!parse(content_, message)) return false;
        count(message, s);
        contents_.loose.push_back({message.log_time, offset, length});
        return true;
      }
      case Opcode::chunk:
        return take_chunk(offset, length, fault);
      case Opcode::attachment: {
        Attachment a;
        bool crc_fits = true;
        if (!parse(content_, a, crc_fits)) return false;
        contents_.attachments.push_back(
            {offset, length, a.log_time, a.create_time, a.data.size(), a.name, a.media_type});
        ++s.attachment_count;
        return true;
      }
      case Opcode::metadata: {
        Metadata m;
        if (!parse(content_, m)) return false;
        contents_.metadata.push_back({offset, length, m.name});
        ++s.metadata_count;
        return true;
      }
      default:
        return true;
    }
  }

  bool take_declaration(Opcode opcode, BytesView content, std::uint64_t offset, Fault& fault) {
    Schema schema;
    Channel channel;
    const bool parsed = opcode == Opcode::schema ? parse(content, schema) : parse(content, channel);
    if (!parsed) return false;
    fault = {offset, "one id has two meanings"};
    return opcode == Opcode::schema ? keep(contents_.schemas, schema) : keep(contents_.channels, channel);
  }

  bool take_chunk(std::uint64_t offset, std::uint64_t length, Fault& fault) {
    Chunk chunk;
    if (!open_chunk(content_, offset, chunk, records_, fault)) return false;
    ChunkIndex index{.chunk_start = offset,
                     .chunk_length = length,
                     .compression = chunk.compression,
                     .compressed_size = chunk.records.size(),
                     .uncompressed_size = records_.size()};
    std::size_t inside = 0;
    RecordView record;
    bool has_messages = false;
    std::set<std::uint16_t> channels;
    while (inside < records_.size()) {
      fault = {offset, "a record in the chunk does not hold what it should"};
      if (!next_record(records_, inside, record)) return false;
      if (record.opcode == Opcode::schema || record.opcode == Opcode::channel) {
        if (!take_declaration(record.opcode, record.content, offset, fault)) return false;
      } else if (record.opcode == Opcode::message) {
        Message message;
        if (!parse(record.content, message)) return false;
        count(message, contents_.statistics);
        channels.insert(message.channel_id);
        // From the messages, not from the chunk's own word.
        index.start_time = has_messages ? std::min(index.start_time, message.log_time) : message.log_time;
        index.end_time = std::max(index.end_time, message.log_time);
        has_messages = true;
      }
    }
    for (const std::uint16_t channel : channels) index.message_index_offsets.emplace_back(channel, 0);
    contents_.chunks.push_back(std::move(index));
    ++contents_.statistics.chunk_count;
    return true;
  }

  const ByteSource& file_;
  Contents& contents_;
  Bytes content_;
  Bytes records_;
};

}  // namespace

bool read_record(const ByteSource& file, std::uint64_t offset, Opcode& opcode, Bytes& content, Fault& fault) {
  Bytes prefix;
  fault = {offset, "the file ends within a record"};
  if (!file.read(offset, kRecordPrefix, prefix)) return false;
  ByteReader reader(prefix);
  std::uint8_t code = 0;
  std::uint64_t length = 0;
  if (!reader.number(code) || !reader.number(length)) return false;
  opcode = static_cast<Opcode>(code);
  if (code == 0) {
    fault.what = "no record begins here";
    return false;
  }
  const std::uint64_t held = file.size() - offset - kRecordPrefix;
  if (length > std::min(held, kLargestRecord)) {
    fault.what = "a record claims " + std::to_string(length) + " bytes, more than " +
                 (length > held ? "the file holds" : "any record may have");
    return false;
  }
  return file.read(offset + kRecordPrefix, length, content);
}

bool open_chunk(BytesView content, std::uint64_t offset, Chunk& chunk, Bytes& records, Fault& fault) {
  fault = {offset, "the chunk does not hold what a chunk holds"};
  if (!parse(content, chunk)) return false;
  const std::optional<Compression> compression = compression_of(chunk.compression);
  fault.what = "the chunk's compression \"" + chunk.compression + "\" is unknown; known: none, lz4, zstd";
  if (!compression) return false;
  fault.what =
      "the chunk does not decompress to the " + std::to_string(chunk.uncompressed_size) + " bytes it claims";
  if (!decompress(*compression, chunk.records, chunk.uncompressed_size, records)) return false;
  fault.what = "the checksum of the chunk does not fit";
  return chunk.uncompressed_crc == 0 || chunk.uncompressed_crc == crc32(records);
}

Contents read_contents(const ByteSource& file) {
  Bytes start;
  if (!file.read(0, kMagic.size(), start) || !is_magic(start)) {
    throw std::runtime_error(file.path().string() + " is no MCAP file: " +
                             (file.size() == 0 ? "it is empty" : "it does not begin as one (byte 0)"));
  }
  Fault fault;
  std::optional<Contents> summarised = from_summary(file, fault);
  Contents contents = summarised ? std::move(*summarised) : Contents{};
  if (!summarised) {
    contents.faults.push_back(fault);
    Walk(file, contents).run();
    Statistics& s = contents.statistics;
    s.schema_count = static_cast<std::uint16_t>(contents.schemas.size());
    s.channel_count = static_cast<std::uint32_t>(contents.channels.size());
  }
  Opcode opcode{};
  Bytes content;
  if (!read_record(file, kMagic.size(), opcode, content, fault) || opcode != Opcode::header ||
      !parse(content, contents.header)) {
    contents.faults.push_back({kMagic.size(), "the header is missing"});
  }
  return contents;
}

}  // namespace bw::bag::mcap
