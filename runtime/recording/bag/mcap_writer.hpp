// Writes one MCAP file: messages in compressed chunks with their indexes, a summary at the end. A file that
// is cut anywhere still opens up to its last whole chunk: every chunk repeats the schemas and channels that
// it uses.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/recording/bag/byte_sink.hpp"
#include "runtime/recording/bag/compression.hpp"
#include "runtime/recording/bag/mcap_records.hpp"

namespace bw::bag::mcap {

struct WriterOptions {
  Compression compression = Compression::zstd;
  std::uint64_t chunk_size = std::uint64_t{1} << 20;  ///< a chunk closes before it grows beyond this [bytes]
  std::uint64_t chunk_duration = 1'000'000'000;       ///< or spans more than this [ns]
  std::string profile = "ros2";
  std::string library = "bandwagon";
};

class Writer {
 public:
  /// Writes magic and header. Every call may throw what the sink throws; then the file is a cut one.
  Writer(std::shared_ptr<ByteSink> sink, WriterOptions options);

  /// Channels are known by the ids they come with; both must be unique and not 0.
  void add_schema(Schema schema);
  void add_channel(Channel channel);
  /// Of a channel that was added. Messages keep the order of writing.
  void write(const Message& message);
  void write(const Attachment& attachment);
  void write(const Metadata& metadata);
  /// Ends the open chunk, so that what was written so far survives a kill.
  void flush();
  /// To sync what was flushed.
  [[nodiscard]] const std::shared_ptr<ByteSink>& sink() const { return sink_; }
  /// Writes summary and footer. Nothing may be written after that.
  void close();

  /// What the file will hold at least when it is closed now [bytes].
  [[nodiscard]] std::uint64_t size() const { return sink_->size() + chunk_.size(); }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  void declare_in_chunk(std::uint16_t channel_id);
  void put(BytesView bytes);
  void write_message_indexes(ChunkIndex& index);
  void append_summary(Bytes& out, std::uint64_t start);

  WriterOptions options_;
  std::shared_ptr<ByteSink> sink_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;

  Bytes chunk_;  ///< the open one, uncompressed
  std::uint64_t chunk_start_ = 0;
  std::uint64_t chunk_end_ = 0;
  bool chunk_has_messages_ = false;
  std::map<std::uint16_t, MessageIndex> chunk_messages_;
  std::map<std::uint16_t, bool> chunk_schemas_;
  Bytes compressed_;
  Bytes record_;

  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  Statistics statistics_;
  std::uint32_t data_crc_ = 0;
};

}  // namespace bw::bag::mcap
