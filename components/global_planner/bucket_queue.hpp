// A priority queue for keys that never fall below the last one taken by more than a bucket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bw {

/// A ring of buckets of kWidth keys each; newest first inside a bucket. Keys of all entries in the queue must
/// lie within the range given to reset() of the smallest one. Keeps its memory between searches.
template <class Entry>
class BucketQueue {
 public:
  static constexpr unsigned kShift = 8;
  static constexpr std::uint32_t kWidth = 1u << kShift;

  /// Empties the queue. `range`: largest difference of keys held at once.
  void reset(std::uint32_t first_key, std::uint32_t range) {
    std::size_t count = 1;
    while (count < (range >> kShift) + 3) count *= 2;
    if (buckets_.size() < count) buckets_.resize(count);
    for (std::vector<Entry>& bucket : buckets_) bucket.clear();
    mask_ = static_cast<std::uint32_t>(buckets_.size() - 1);
    current_ = first_key >> kShift;
    size_ = 0;
  }

  void push(std::uint32_t key, const Entry& entry) {
    buckets_[(key >> kShift) & mask_].push_back(entry);
    ++size_;
  }

  bool empty() const { return size_ == 0; }

  /// The newest entry of the first bucket that holds one; the queue must not be empty.
  Entry pop() {
    while (buckets_[current_ & mask_].empty()) ++current_;
    std::vector<Entry>& bucket = buckets_[current_ & mask_];
    const Entry entry = bucket.back();
    bucket.pop_back();
    --size_;
    return entry;
  }

 private:
  std::vector<std::vector<Entry>> buckets_;
  std::uint32_t mask_ = 0;
  std::uint32_t current_ = 0;
  std::size_t size_ = 0;
};

}  // namespace bw
