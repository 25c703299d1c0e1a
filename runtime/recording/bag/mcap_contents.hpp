// What an MCAP file holds, messages apart: from its summary, or, where that is missing or broken, from a walk
// over the file up to the first damage.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/recording/bag/byte_source.hpp"
#include "runtime/recording/bag/mcap_records.hpp"

namespace bw::bag::mcap {

/// No record and no summary beyond this is read, whatever the file claims and however large it is [bytes].
inline constexpr std::uint64_t kLargestRecord = std::uint64_t{1} << 30;

/// Something in the file that is not as it should be.
struct Fault {
  std::uint64_t offset = 0;  ///< in the file [bytes]
  std::string what;
};

/// A message outside of any chunk.
struct LooseMessage {
  std::uint64_t log_time = 0;
  std::uint64_t offset = 0;  ///< of the record
  std::uint64_t length = 0;  ///< with its prefix
};

struct Contents {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::vector<ChunkIndex> chunks;
  std::vector<LooseMessage> loose;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  Statistics statistics;
  std::uint64_t summary_start = 0;  ///< in the file [bytes]
  bool from_summary = false;        ///< false: the file was not closed, or its summary is broken
  std::vector<Fault> faults;
};

/// Throws std::runtime_error naming the file for one that is no MCAP file at all; anything else becomes a
/// fault.
[[nodiscard]] Contents read_contents(const ByteSource& file);

/// One record whose claimed length the file really holds; false, with the fault, otherwise.
[[nodiscard]] bool read_record(const ByteSource& file, std::uint64_t offset, Opcode& opcode, Bytes& content,
                               Fault& fault);

/// The decompressed records of the chunk record in `content`; `offset` is that of the chunk, for the fault.
[[nodiscard]] bool open_chunk(BytesView content, std::uint64_t offset, Chunk& chunk, Bytes& records,
                              Fault& fault);

}  // namespace bw::bag::mcap
