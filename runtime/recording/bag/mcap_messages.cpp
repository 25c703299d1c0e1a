#include "runtime/recording/bag/mcap_messages.hpp"

#include <algorithm>
#include <utility>

namespace bw::bag::mcap {
namespace {

constexpr std::uint64_t kMaxOpen = std::uint64_t{32} << 20;  // of decompressed chunks kept [bytes]

}  // namespace

Messages::Messages(const ByteSource& file, const Contents& contents, Selection selection)
    : file_(file), contents_(contents), selection_(std::move(selection)), loose_(contents.loose) {
  for (std::size_t i = 0; i < contents_.chunks.size(); ++i) {
    if (is_wanted(contents_.chunks[i])) order_.push_back(i);
  }
  const auto rank = [&](std::size_t i) {
    return std::pair(contents_.chunks[i].start_time, contents_.chunks[i].chunk_start);
  };
  // As recorders write them they are in order, and a long bag has very many.
  if (!std::ranges::is_sorted(order_, {}, rank)) std::ranges::sort(order_, {}, rank);
  std::ranges::sort(loose_, {}, [](const LooseMessage& m) { return std::pair(m.log_time, m.offset); });
}

bool Messages::is_over(std::uint64_t time) const {
  return time >= selection_.end && selection_.end != std::numeric_limits<std::uint64_t>::max();
}

bool Messages::is_wanted(const ChunkIndex& chunk) const {
  if (chunk.end_time < selection_.start || is_over(chunk.start_time)) return false;
  if (!selection_.channels || chunk.message_index_offsets.empty()) return true;
  return std::ranges::any_of(chunk.message_index_offsets,
                             [&](const auto& entry) { return selection_.channels->contains(entry.first); });
}

bool Messages::is_wanted(const Message& message) const {
  return message.log_time >= selection_.start && !is_over(message.log_time) &&
         (!selection_.channels || selection_.channels->contains(message.channel_id)) &&
         contents_.channels.contains(message.channel_id);
}

const Bytes* Messages::records_of(std::size_t chunk) {
  const auto found = std::ranges::find(open_, chunk, &OpenChunk::chunk);
  if (found != open_.end()) {
    open_.splice(open_.begin(), open_, found);
    return &open_.front().records;
  }
  const ChunkIndex& index = contents_.chunks[chunk];
  Opcode opcode{};
  if (!read_record(file_, index.chunk_start, opcode, record_, fault_)) return nullptr;
  fault_ = {index.chunk_start, "the summary names a chunk where there is none"};
  if (opcode != Opcode::chunk) return nullptr;
  Chunk header;
  OpenChunk opened{.chunk = chunk, .records = {}};
  if (!open_chunk(record_, index.chunk_start, header, opened.records, fault_)) return nullptr;
  open_size_ += opened.records.size();
  open_.push_front(std::move(opened));
  while (open_size_ > kMaxOpen && open_.size() > 1) {
    open_size_ -= open_.back().records.size();
    open_.pop_back();
  }
  return &open_.front().records;
}

bool Messages::enter(std::size_t chunk) {
  const Bytes* records = records_of(chunk);
  if (records == nullptr) return false;
  const std::uint64_t at = contents_.chunks[chunk].chunk_start;
  std::size_t offset = 0;
  RecordView record;
  Message message;
  while (offset < records->size()) {
    fault_ = {at, "a record in the chunk does not hold what it should"};
    if (!next_record(*records, offset, record)) return false;
    if (record.opcode != Opcode::message) continue;
    if (!parse(record.content, message)) return false;
    if (is_wanted(message)) locations_.push({message.log_time, at, record.offset, chunk});
  }
  return true;
}

bool Messages::fetch(const Location& location, Message& message) {
  if (location.chunk == kNoChunk) {
    Opcode opcode{};
    return read_record(file_, location.file_offset, opcode, record_, fault_) && parse(record_, message);
  }
  const Bytes* records = records_of(location.chunk);
  std::size_t offset = location.offset;
  RecordView record;
  return records != nullptr && next_record(*records, offset, record) && parse(record.content, message);
}

Step Messages::next(Message& message) {
  const auto is_due = [&](std::uint64_t time) { return locations_.empty() || time <= locations_.top().time; };
  while (true) {
    while (entered_ < order_.size() && is_due(contents_.chunks[order_[entered_]].start_time)) {
      if (!enter(order_[entered_++])) return Step::damaged;
    }
    while (next_loose_ < loose_.size() && is_due(loose_[next_loose_].log_time)) {
      const LooseMessage& loose = loose_[next_loose_++];
      locations_.push({loose.log_time, loose.offset, 0, kNoChunk});
    }
    if (locations_.empty()) return Step::end;
    const Location location = locations_.top();
    locations_.pop();
    if (!fetch(location, message)) return Step::damaged;
    if (is_wanted(message)) return Step::message;
  }
}

}  // namespace bw::bag::mcap
