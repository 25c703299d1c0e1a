// gzip for those who take it, and what is inside for the others.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace bw::web {

/// Of a header Accept-Encoding: gzip or * is there and not with q=0.
bool accepts_gzip(std::string_view accept_encoding);

/// Of bytes that this program carries. Throws std::runtime_error where they are no gzip.
std::string inflated(std::span<const std::uint8_t> gzip);

}  // namespace bw::web
