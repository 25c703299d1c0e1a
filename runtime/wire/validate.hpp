// Says whether bytes are a well-formed message of a type, before anything is allocated for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "runtime/wire/type_description.hpp"

namespace bw {

/// True if `cdr` (encapsulation included) holds a whole message: plain CDR, every length within the remaining
/// bytes and its bound, strings terminated, booleans 0 or 1. Bytes after the message are tolerated, as ROS 2
/// does. Otherwise false and, if asked, which field is wrong and where. Time is linear in the bytes; memory
/// is constant.
[[nodiscard]] bool validate(const TypeDescription& type, std::span<const std::uint8_t> cdr,
                            std::string* error = nullptr);

/// Bytes that the message takes, encapsulation included: DDS pads what it carries to a multiple of four.
/// Nothing when validate() refuses it.
[[nodiscard]] std::optional<std::size_t> message_size(const TypeDescription& type,
                                                      std::span<const std::uint8_t> cdr);

}  // namespace bw
