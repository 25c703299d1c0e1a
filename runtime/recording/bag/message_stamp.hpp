// The stamp that a message carries itself.
#pragma once

#include <optional>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bytes.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::bag {

/// Of a type that begins with a std_msgs/Header or a builtin_interfaces/Time.
[[nodiscard]] bool begins_with_stamp(const TypeDescription& type);

/// Reads it from the bytes of such a message; nothing when they are too short or no plain CDR.
[[nodiscard]] std::optional<Time> stamp_of(BytesView cdr);

}  // namespace bw::bag
