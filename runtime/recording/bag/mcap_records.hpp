// The records of an MCAP file, version 0 (mcap.dev, specification). Values only: no file, no compression.
//
//   file = magic, Header, data section, DataEnd, summary, summary offsets, Footer, magic
//   record = opcode (1 byte), length of the content (8 bytes), content
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordPrefix = 9;  ///< opcode and length [bytes]
inline constexpr std::size_t kFooterLength = 20;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

struct Header {
  std::string profile;
  std::string library;
};

struct Footer {
  std::uint64_t summary_start = 0;         ///< 0: no summary
  std::uint64_t summary_offset_start = 0;  ///< 0: none
  std::uint32_t summary_crc = 0;           ///< 0: not available
};

struct Schema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  Bytes data;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none
  std::string topic;
  std::string message_encoding;
  std::map<std::string, std::string> metadata;
  bool operator==(const Channel&) const = default;
};

/// Times are nanoseconds. The payload lies in the bytes that were parsed.
struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  BytesView data;
};

/// The records inside lie in the bytes that were parsed, compressed as `compression` says.
struct Chunk {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not available
  std::string compression;             ///< "", "lz4" (frame format) or "zstd"
  BytesView records;
};

struct MessageIndex {
  std::uint16_t channel_id = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>>
      entries;  ///< log time, offset in the uncompressed chunk
};

struct ChunkIndex {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t chunk_start = 0;                                               ///< in the file
  std::uint64_t chunk_length = 0;                                              ///< with its prefix
  std::vector<std::pair<std::uint16_t, std::uint64_t>> message_index_offsets;  ///< by channel, in the file
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;  ///< 0: unknown
  std::string name;
  std::string media_type;
  Bytes data;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with its prefix
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};

struct Metadata {
  std::string name;
  std::map<std::string, std::string> entries;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with its prefix
  std::string name;
};

struct SummaryOffset {
  std::uint8_t group_opcode = 0;
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
};

/// Append the record with its prefix.
void append(Bytes& out, const Header& record);
void append(Bytes& out, const Footer& record);
void append(Bytes& out, const Schema& record);
void append(Bytes& out, const Channel& record);
void append(Bytes& out, const Message& record);
void append(Bytes& out, const Chunk& record);
void append(Bytes& out, const MessageIndex& record);
void append(Bytes& out, const ChunkIndex& record);
void append(Bytes& out, const Attachment& record);  ///< with its CRC
void append(Bytes& out, const AttachmentIndex& record);
void append(Bytes& out, const Statistics& record);
void append(Bytes& out, const Metadata& record);
void append(Bytes& out, const MetadataIndex& record);
void append(Bytes& out, const SummaryOffset& record);
void append_data_end(Bytes& out, std::uint32_t data_section_crc);

/// Read the content of a record; false when it does not hold one. Bytes after it are ignored, as the format
/// asks.
[[nodiscard]] bool parse(BytesView content, Header& record);
[[nodiscard]] bool parse(BytesView content, Footer& record);
[[nodiscard]] bool parse(BytesView content, Schema& record);
[[nodiscard]] bool parse(BytesView content, Channel& record);
[[nodiscard]] bool parse(BytesView content, Message& record);
[[nodiscard]] bool parse(BytesView content, Chunk& record);
[[nodiscard]] bool parse(BytesView content, ChunkIndex& record);
[[nodiscard]] bool parse(BytesView content, Attachment& record, bool& crc_fits);
[[nodiscard]] bool parse(BytesView content, AttachmentIndex& record);
[[nodiscard]] bool parse(BytesView content, Statistics& record);
[[nodiscard]] bool parse(BytesView content, Metadata& record);
[[nodiscard]] bool parse(BytesView content, MetadataIndex& record);

/// One record out of consecutive ones.
struct RecordView {
  Opcode opcode{};
  std::size_t offset = 0;  ///< of its prefix
  BytesView content;
};

/// The record at `offset`, which moves behind it; false at the end, or where what follows is no whole record.
[[nodiscard]] bool next_record(BytesView records, std::size_t& offset, RecordView& record);

/// CRC-32 as zlib computes it, continued from `before`.
[[nodiscard]] std::uint32_t crc32(BytesView bytes, std::uint32_t before = 0);

}  // namespace bw::bag::mcap
