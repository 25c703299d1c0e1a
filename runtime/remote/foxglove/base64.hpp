// Bytes as text (RFC 4648, section 4), with padding.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bw::foxglove {

std::string to_base64(std::span<const std::uint8_t> bytes);
/// Nothing where it is not base64, its padding and unused bits included.
std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

}  // namespace bw::foxglove
