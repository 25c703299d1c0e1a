// The compressions that chunks of an MCAP file may have.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

enum class Compression { none, lz4, zstd };

/// As MCAP names it: "", "lz4", "zstd". Nothing for any other name.
[[nodiscard]] std::optional<Compression> compression_of(std::string_view name);
[[nodiscard]] std::string_view name_of(Compression compression);

/// No more than this is allocated for one chunk, whatever the file claims [bytes].
inline constexpr std::uint64_t kLargestChunk = std::uint64_t{256} << 20;

/// Replaces `out` by the compressed bytes (zstd level 1, LZ4 frame, or a copy). Throws std::runtime_error
/// with the library's reason.
void compress(Compression compression, BytesView bytes, Bytes& out);

/// Replaces `out` by exactly `size` bytes; false when that is not what `bytes` hold, or more than
/// kLargestChunk. What is allocated grows with what really comes out.
[[nodiscard]] bool decompress(Compression compression, BytesView bytes, std::uint64_t size, Bytes& out);

}  // namespace bw::bag
