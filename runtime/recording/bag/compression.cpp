#include "runtime/recording/bag/compression.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include <lz4frame.h>
#include <zstd.h>

namespace bw::bag {
namespace {

constexpr int kZstdLevel = 1;                             // fast: a robot's processor has other work
constexpr std::size_t kFirstStep = std::size_t{1} << 20;  // of the output buffer [bytes]

struct ZstdFree {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};
struct Lz4Free {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

/// Where the next decompressed bytes go: what is left of `out`, grown towards `size`; once that is full a
/// byte that must stay empty, so that a decoder can end its frame but not say more than was claimed.
struct Room {
  std::uint8_t* data;
  std::size_t size;
};
Room room_in(Bytes& out, std::size_t used, std::uint64_t size, std::uint8_t& excess) {
  if (used == size) return {&excess, 1};
  if (used == out.size()) {
    const std::uint64_t wanted = std::max<std::uint64_t>(kFirstStep, 2 * std::uint64_t{out.size()});
    out.resize(static_cast<std::size_t>(std::min(size, wanted)));
  }
  return {out.data() + used, out.size() - used};
}

bool decompress_zstd(BytesView bytes, std::uint64_t size, Bytes& out) {
  const std::unique_ptr<ZSTD_DCtx, ZstdFree> context(ZSTD_createDCtx());
  if (!context) return false;
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t used = 0;
  std::uint8_t excess = 0;
  while (true) {
    const Room room = room_in(out, used, size, excess);
    ZSTD_outBuffer piece{room.data, room.size, 0};
    const std::size_t before = in.pos;
    const std::size_t hint = ZSTD_decompressStream(context.get(), &piece, &in);
    if (ZSTD_isError(hint) != 0U) return false;
    used += piece.pos;
    if (used > size) return false;
    if (hint == 0 && in.pos == in.size) return used == size;
    if (piece.pos == 0 && in.pos == before) return false;  // cut short
  }
}

bool decompress_lz4(BytesView bytes, std::uint64_t size, Bytes& out) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0U) return false;
  const std::unique_ptr<LZ4F_dctx, Lz4Free> context(raw);
  std::size_t used = 0;
  std::size_t read = 0;
  std::uint8_t excess = 0;
  while (true) {
    const Room room = room_in(out, used, size, excess);
    std::size_t produced = room.size;
    std::size_t consumed = bytes.size() - read;
    const std::size_t hint =
        LZ4F_decompress(context.get(), room.data, &produced, bytes.data() + read, &consumed, nullptr);
    if (LZ4F_isError(hint) != 0U) return false;
    used += produced;
    read += consumed;
    if (used > size) return false;
    if (hint == 0) return used == size && read == bytes.size();
    if (produced == 0 && consumed == 0) return false;  // cut short
  }
}

}  // namespace

std::optional<Compression> compression_of(std::string_view name) {
  if (name.empty()) return Compression::none;
  if (name == "lz4") return Compression::lz4;
  if (name == "zstd") return Compression::zstd;
  return std::nullopt;
}

std::string_view name_of(Compression compression) {
  return compression == Compression::none ? "" : compression == Compression::lz4 ? "lz4" : "zstd";
}

void compress(Compression compression, BytesView bytes, Bytes& out) {
  if (compression == Compression::none) {
    out.assign(bytes.begin(), bytes.end());
    return;
  }
  if (compression == Compression::zstd) {
    out.resize(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kZstdLevel);
    if (ZSTD_isError(size) != 0U) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
    out.resize(size);
    return;
  }
  out.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
  const std::size_t size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0U) throw std::runtime_error(std::string("lz4: ") + LZ4F_getErrorName(size));
  out.resize(size);
}

bool decompress(Compression compression, BytesView bytes, std::uint64_t size, Bytes& out) {
  out.clear();
  if (size > kLargestChunk) return false;
  if (compression == Compression::none) {
    if (bytes.size() != size) return false;
    out.assign(bytes.begin(), bytes.end());
    return true;
  }
  if (size == 0) return true;
  return compression == Compression::zstd ? decompress_zstd(bytes, size, out)
                                          : decompress_lz4(bytes, size, out);
}

}  // namespace bw::bag
