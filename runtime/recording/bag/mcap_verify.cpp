#include "runtime/recording/bag/mcap_verify.hpp"

#include <algorithm>
#include <optional>

namespace bw::bag::mcap {
namespace {

constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;                         // read at a time [bytes]
constexpr std::uint64_t kDataEndLength = kRecordPrefix + sizeof(std::uint32_t);  // with its prefix [bytes]

/// The record DataEnd stands before the summary, which only a closed file has.
std::optional<Fault> verify_data(const ByteSource& file, std::uint64_t summary_start) {
  if (summary_start < kDataEndLength) return std::nullopt;
  const std::uint64_t end = summary_start - kDataEndLength;
  Opcode opcode{};
  Bytes bytes;
  Fault fault;
  std::uint32_t said = 0;
  if (!read_record(file, end, opcode, bytes, fault) || opcode != Opcode::data_end ||
      !ByteReader(bytes).number(said))
    return Fault{end, "the end of the data section is missing"};
  if (said == 0) return std::nullopt;  // not available
  std::uint32_t crc = 0;
  for (std::uint64_t offset = 0; offset < end; offset += bytes.size()) {
    if (!file.read(offset, std::min(kPiece, end - offset), bytes))
      return Fault{offset, "the file cannot be read"};
    crc = crc32(bytes, crc);
  }
  if (crc == said) return std::nullopt;
  return Fault{end, "the checksum of the data section does not fit: something before this place was changed"};
}

}  // namespace

std::vector<Fault> verify(const ByteSource& file, const Contents& contents) {
  std::vector<Fault> faults;
  Opcode opcode{};
  Bytes content;
  Fault fault;
  for (const AttachmentIndex& index : contents.attachments) {
    Attachment record;
    bool crc_fits = false;
    const bool fine = read_record(file, index.offset, opcode, content, fault) &&
                      opcode == Opcode::attachment && parse(content, record, crc_fits) && crc_fits;
    if (!fine) faults.push_back({index.offset, "the attachment " + index.name + " is damaged"});
  }
  for (const MetadataIndex& index : contents.metadata) {
    Metadata record;
    const bool fine = read_record(file, index.offset, opcode, content, fault) && opcode == Opcode::metadata &&
                      parse(content, record);
    if (!fine) faults.push_back({index.offset, "the metadata record " + index.name + " is damaged"});
  }
  if (!contents.from_summary) return faults;
  if (const std::optional<Fault> data = verify_data(file, contents.summary_start)) faults.push_back(*data);
  return faults;
}

}  // namespace bw::bag::mcap
