#include "runtime/recording/bag/snapshot_ring.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace bw::bag {
namespace {

/// Before the bytes of each message.
struct Prefix {
  std::uint64_t topic = 0;
  std::uint64_t size = 0;  ///< [bytes]
  std::int64_t log_time = 0;
  std::int64_t publish_time = 0;
};

constexpr std::size_t kLeastBlocks = 8;  // in the memory

std::size_t size_in_block(std::size_t size) {
  return (sizeof(Prefix) + size + alignof(Prefix) - 1) / alignof(Prefix) * alignof(Prefix);
}

}  // namespace

class SnapshotRing::Block {
 public:
  explicit Block(std::size_t size)
      : capacity(size), bytes(std::make_unique_for_overwrite<std::uint8_t[]>(size)) {}

  std::size_t capacity;  ///< [bytes]
  std::unique_ptr<std::uint8_t[]> bytes;
  std::size_t used = 0;     ///< [bytes]
  std::uint64_t first = 0;  ///< number of its first message
  std::uint64_t count = 0;
  Time oldest;
  Time newest;
  bool has_latched = false;
};

bool SnapshotRing::Stretch::next(KeptMessage& message) {
  if (offset_ >= end_) return false;
  Prefix prefix;
  std::memcpy(&prefix, block_->bytes.get() + offset_, sizeof(prefix));
  message = {.topic = prefix.topic,
             .log_time = {prefix.log_time},
             .publish_time = {prefix.publish_time},
             .data = {block_->bytes.get() + offset_ + sizeof(prefix), prefix.size}};
  offset_ += size_in_block(prefix.size);
  return true;
}

SnapshotRing::SnapshotRing(const SnapshotRingOptions& options) : options_(options) {
  options_.block_size = std::min(options_.block_size, options_.memory / kLeastBlocks);
}

SnapshotRing::~SnapshotRing() = default;

std::size_t SnapshotRing::add_topic(std::size_t latched) {
  depths_.push_back(latched);
  return depths_.size() - 1;
}

bool SnapshotRing::add(const KeptMessage& message) {
  const std::size_t size = size_in_block(message.data.size());
  if (size > options_.memory) return false;
  newest_ = std::max(newest_, message.log_time);
  make_room(size, message.log_time);
  Block& block = *blocks_.back();
  const Prefix prefix{message.topic, message.data.size(), message.log_time.nanoseconds,
                      message.publish_time.nanoseconds};
  std::memcpy(block.bytes.get() + block.used, &prefix, sizeof(prefix));
  if (!message.data.empty())
    std::memcpy(block.bytes.get() + block.used + sizeof(prefix), message.data.data(), message.data.size());
  block.used += size;
  block.oldest = block.count == 0 ? message.log_time : std::min(block.oldest, message.log_time);
  block.newest = block.count == 0 ? message.log_time : std::max(block.newest, message.log_time);
  block.has_latched |= depths_[message.topic] > 0;
  ++block.count;
  ++count_;
  return true;
}

/// Leaves a block at the back with so much room.
void SnapshotRing::make_room(std::size_t size, Time now) {
  const Time oldest = now - options_.keep;
  while (blocks_.size() > 1 && blocks_.front()->newest < oldest &&
         blocks_.front()->first + blocks_.front()->count <= read_)
    drop_oldest();
  if (!blocks_.empty() && blocks_.back()->used + size <= blocks_.back()->capacity) return;
  const std::size_t capacity = std::max(size, options_.block_size);
  while (!blocks_.empty() && memory_ + capacity > options_.memory) drop_oldest();
  blocks_.push_back(std::make_shared<Block>(capacity));
  blocks_.back()->first = count_;
  memory_ += capacity;
}

void SnapshotRing::drop_oldest() {
  const std::shared_ptr<Block> block = std::move(blocks_.front());
  blocks_.pop_front();
  memory_ -= block->capacity;
  if (!block->has_latched) return;
  Stretch stretch;
  stretch.block_ = block;
  stretch.end_ = block->used;
  for (KeptMessage message; stretch.next(message);) {
    const std::size_t depth = depths_[message.topic];
    if (depth == 0) continue;
    auto& kept = latched_[message.topic];
    kept.push_back({message.publish_time, {message.data.begin(), message.data.end()}});
    memory_ += message.data.size();
    if (kept.size() <= depth) continue;
    memory_ -= kept.front().data.size();
    kept.pop_front();
  }
}

SnapshotRing::Stretch SnapshotRing::read(Cursor& cursor, std::uint64_t& lost) {
  Stretch stretch;
  // The block of the cursor, or the first one that is left behind it.
  auto block =
      std::ranges::find_if(blocks_, [&](const auto& b) { return b->first + b->count > cursor.message; });
  if (block == blocks_.end()) {
    cursor = end();
  } else {
    const Block& b = **block;
    if (b.first > cursor.message) {
      lost += b.first - cursor.message;
      cursor = {b.first, 0};
    } else if (b.first == cursor.message) {
      cursor.offset = 0;
    }
    stretch.block_ = *block;
    stretch.offset_ = cursor.offset;
    stretch.end_ = b.used;
    cursor = {b.first + b.count, b.used};
  }
  read_ = cursor.message;
  return stretch;
}

SnapshotRing::Cursor SnapshotRing::begin() const {
  return blocks_.empty() ? end() : Cursor{blocks_.front()->first, 0};
}

SnapshotRing::Cursor SnapshotRing::end() const {
  return {count_, blocks_.empty() ? 0 : blocks_.back()->used};
}

Duration SnapshotRing::span() const {
  return blocks_.empty() ? Duration{} : newest_ - blocks_.front()->oldest;
}

}  // namespace bw::bag
