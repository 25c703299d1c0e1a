// Whether a recorded message is what this build knows by the name of its type.
#pragma once

#include <string>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::bag {

struct KnownType {
  const TypeDescription* type = nullptr;  ///< null: its messages pass through undecoded
  std::string why;  ///< what is not the same then; empty where this build has no such type
};

/// By the hash of the type where the bag has one, else by the fields of its schema. Where the bag has neither
/// the name must do; every message is validated before it is used.
[[nodiscard]] KnownType known_type(const BagTopic& topic);

}  // namespace bw::bag
