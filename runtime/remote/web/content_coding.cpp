#include "runtime/remote/web/content_coding.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include <zlib.h>

namespace bw::web {
namespace {

constexpr int kGzip = 15 + 16;  // window bits and zlib's mark for gzip

/// `;q=0`, `; q=0.0`.
bool is_zero_quality(std::string_view parameters) {
  const std::size_t q = parameters.find("q=");
  return q != std::string_view::npos &&
         parameters.substr(q + 2).find_first_not_of("0. ") == std::string_view::npos;
}

}  // namespace

bool accepts_gzip(std::string_view accept_encoding) {
  while (!accept_encoding.empty()) {
    std::string_view one = accept_encoding.substr(0, accept_encoding.find(','));
    accept_encoding.remove_prefix(std::min(accept_encoding.size(), one.size() + 1));
    one.remove_prefix(std::min(one.size(), one.find_first_not_of(' ')));
    const std::string_view coding = one.substr(0, one.find_first_of("; "));
    if ((coding == "gzip" || coding == "*") && !is_zero_quality(one.substr(coding.size()))) return true;
  }
  return false;
}

std::string inflated(std::span<const std::uint8_t> gzip) {
  z_stream stream = {};
  if (inflateInit2(&stream, kGzip) != Z_OK) throw std::runtime_error("zlib does not start");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ends(&stream, inflateEnd);
  stream.next_in = const_cast<std::uint8_t*>(gzip.data());  // zlib reads only
  stream.avail_in = static_cast<uInt>(gzip.size());
  std::string out;
  std::array<char, 65536> part = {};
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(part.data(), part.size() - stream.avail_out);
  }
  if (status != Z_STREAM_END) throw std::runtime_error("a file of the page is no gzip");
  return out;
}

}  // namespace bw::web
