// The last messages of a run, in memory: what is older than asked goes, and the oldest before the memory
// grows too large. The latest messages of latched topics stay. No threads; whoever shares it locks it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

struct SnapshotRingOptions {
  Duration keep = Duration::milliseconds(30'000);
  std::size_t memory = 256'000'000;  ///< of messages, all together [bytes]
  std::size_t block_size = std::size_t{1}
                           << 20;  ///< taken and let go at once, if memory is that large [bytes]
};

/// `data` lives as long as the Block it is in.
struct KeptMessage {
  std::size_t topic = 0;
  Time log_time;
  Time publish_time;
  BytesView data;
};

class SnapshotRing {
 public:
  /// Messages one behind the other. Appending leaves those before as they are, so that they can be read
  /// meanwhile.
  class Block;
  struct Latched {
    Time publish_time;
    Bytes data;
  };
  /// A place between two messages.
  struct Cursor {
    std::uint64_t message = 0;  ///< how many there were before it since the beginning
    std::size_t offset = 0;     ///< in its block [bytes]
  };
  /// Messages of one block, from a cursor on.
  class Stretch {
   public:
    /// False behind the last one.
    bool next(KeptMessage& message);

   private:
    friend class SnapshotRing;
    std::shared_ptr<const Block> block_;
    std::size_t offset_ = 0;
    std::size_t end_ = 0;
  };

  explicit SnapshotRing(const SnapshotRingOptions& options);
  ~SnapshotRing();

  /// Named by what is returned. `latched`: so many messages stay whatever goes.
  std::size_t add_topic(std::size_t latched);
  /// False, and nothing is kept, for one that is larger than the memory.
  bool add(const KeptMessage& message);

  /// What is there from `cursor` on, up to the end of a block at most; moves the cursor behind it, and adds
  /// to `lost` what went before it was read. What lies behind the cursor stays until the memory is full,
  /// however old it is.
  [[nodiscard]] Stretch read(Cursor& cursor, std::uint64_t& lost);
  /// The oldest there is.
  [[nodiscard]] Cursor begin() const;
  /// Behind the newest.
  [[nodiscard]] Cursor end() const;
  /// The last messages of a latched topic that are in no block any more, the oldest first.
  [[nodiscard]] const std::map<std::size_t, std::deque<Latched>>& latched() const { return latched_; }
  [[nodiscard]] std::size_t latched_depth(std::size_t topic) const { return depths_[topic]; }

  [[nodiscard]] std::size_t memory() const { return memory_; }  ///< in use [bytes]
  [[nodiscard]] Duration span() const;                          ///< between the oldest and the newest

 private:
  void make_room(std::size_t size, Time now);
  void drop_oldest();

  SnapshotRingOptions options_;
  std::vector<std::size_t> depths_;  ///< by topic
  std::deque<std::shared_ptr<Block>> blocks_;
  std::map<std::size_t, std::deque<Latched>> latched_;
  std::size_t memory_ = 0;
  std::uint64_t count_ = 0;  ///< messages ever added
  std::uint64_t read_ = 0;   ///< of them, before the cursor of the last read
  Time newest_;
};

}  // namespace bw::bag
