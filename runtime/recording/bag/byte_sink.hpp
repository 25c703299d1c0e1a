// Where a writer's bytes go: a file, or whatever a test puts in its place.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Appends all of `bytes`. Throws std::system_error with the system's reason; a part may have been written
  /// then.
  virtual void write(BytesView bytes) = 0;
  /// Waits until the device keeps what was written, and the file's name. Throws as write() does. Another
  /// thread may write and ask for the size meanwhile.
  virtual void sync() = 0;
  /// Bytes written so far.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
};

/// A new file for its owner alone, since a recording tells who was where; nobody else's is overwritten.
/// Throws std::system_error naming the path.
std::unique_ptr<ByteSink> create_file(const std::filesystem::path& path);

}  // namespace bw::bag
