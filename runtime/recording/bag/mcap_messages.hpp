// The messages of an MCAP file in the order of their log times; those of one time in the order they were
// written.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <vector>

#include "runtime/recording/bag/mcap_contents.hpp"

namespace bw::bag::mcap {

struct Selection {
  std::uint64_t start = 0;                                         ///< log time [ns], inclusive
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();   ///< exclusive, its greatest value apart
  std::optional<std::set<std::uint16_t>> channels = std::nullopt;  ///< nothing: all
};

enum class Step { message, end, damaged };

/// Holds a few decompressed chunks at a time, however long the file and however its chunks overlap.
class Messages {
 public:
  /// Both must outlive this.
  Messages(const ByteSource& file, const Contents& contents, Selection selection);

  /// `message` lies in memory that is valid until the next call. `damaged`: fault() says what is lost; the
  /// next call goes on behind it.
  Step next(Message& message);
  const Fault& fault() const { return fault_; }

 private:
  /// Where a message lies; in the order of reading.
  struct Location {
    std::uint64_t time = 0;
    std::uint64_t file_offset = 0;  ///< of its chunk, or of its own record
    std::size_t offset = 0;         ///< in the decompressed chunk
    std::size_t chunk = 0;          ///< kNoChunk: loose
    bool operator>(const Location& other) const {
      return std::tie(time, file_offset, offset) > std::tie(other.time, other.file_offset, other.offset);
    }
  };
  static constexpr std::size_t kNoChunk = std::numeric_limits<std::size_t>::max();

  struct OpenChunk {
    std::size_t chunk = 0;
    Bytes records;
  };

  bool is_over(std::uint64_t time) const;
  bool is_wanted(const ChunkIndex& chunk) const;
  bool is_wanted(const Message& message) const;
  bool enter(std::size_t chunk);
  const Bytes* records_of(std::size_t chunk);
  bool fetch(const Location& location, Message& message);

  const ByteSource& file_;
  const Contents& contents_;
  Selection selection_;
  std::vector<std::size_t> order_;  ///< wanted chunks by start time, then by location
  std::size_t entered_ = 0;         ///< of `order_`
  std::vector<LooseMessage> loose_;
  std::size_t next_loose_ = 0;
  std::priority_queue<Location, std::vector<Location>, std::greater<>> locations_;
  std::list<OpenChunk> open_;  ///< the one used last first
  std::uint64_t open_size_ = 0;
  Bytes record_;
  Fault fault_;
};

}  // namespace bw::bag::mcap
