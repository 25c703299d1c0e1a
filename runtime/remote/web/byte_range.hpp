// `Range: bytes=` of a request (RFC 9110, 14.1): one range; more than one, or what is none, is left out of
// account, as the RFC allows.
#pragma once

#include <cstdint>
#include <string_view>

namespace bw::web {

struct ByteRange {
  enum class Kind : std::uint8_t { whole, part, unsatisfiable };
  Kind kind = Kind::whole;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;  ///< behind the last byte
};

ByteRange parse_range(std::string_view header, std::uint64_t size);

}  // namespace bw::web
