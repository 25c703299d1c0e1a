// A priority queue for whole-number keys that never fall more than a bucket below the last one taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace bw {

/// A ring of buckets of kWidth keys each; newest first inside a bucket. Keys of all entries in the queue must
/// lie within the range given to reset() of the smallest one. Entries live in one pool, whose slots are used
/// again while they are still in the cache; the memory is kept between searches.
template <class Entry>
class BucketQueue {
 public:
  static constexpr unsigned kShift = 4;
  static constexpr std::uint32_t kWidth = 1u << kShift;

  /// Empties the queue. `range`: largest difference of keys held at once.
  void reset(std::uint32_t first_key, std::uint32_t range) {
    std::size_t count = 1;
    while (count < (range >> kShift) + 3) count *= 2;
    heads_.assign(count, kNone);
    mask_ = static_cast<std::uint32_t>(count - 1);
    pool_.clear();
    free_ = kNone;
    current_ = first_key >> kShift;
    size_ = 0;
  }

  void push(std::uint32_t key, const Entry& entry) {
    std::uint32_t& head = heads_[(key >> kShift) & mask_];
    if (free_ == kNone) {
      pool_.push_back({entry, head});
      head = static_cast<std::uint32_t>(pool_.size() - 1);
    } else {
      const std::uint32_t slot = free_;
      free_ = pool_[slot].next;
      pool_[slot] = {entry, head};
      head = slot;
    }
    ++size_;
  }

  bool empty() const { return size_ == 0; }

  /// The newest entry of the first bucket that holds one; the queue must not be empty.
  Entry pop() {
    while (heads_[current_ & mask_] == kNone) ++current_;
    const std::uint32_t slot = heads_[current_ & mask_];
    heads_[current_ & mask_] = pool_[slot].next;
    pool_[slot].next = free_;
    free_ = slot;
    --size_;
    return pool_[slot].entry;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Node {
    Entry entry;
    std::uint32_t next = kNone;
  };

  std::vector<std::uint32_t> heads_;
  std::vector<Node> pool_;
  std::uint32_t free_ = kNone;
  std::uint32_t mask_ = 0;
  std::uint32_t current_ = 0;
  std::size_t size_ = 0;
};

}  // namespace bw
