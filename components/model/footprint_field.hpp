// A footprint as a parameter: a text in Nav2's form, or a list in YAML; what is no footprint is refused where
// it was written.
#pragma once

#include <string>
#include <string_view>

#include "components/model/footprint_outline.hpp"
#include "runtime/base/field.hpp"

namespace bw {

/// Empty: none.
inline Field footprint_field(std::string_view doc) {
  return {.unit = "m",
          .list_as_text = true,
          .rule = [](std::string_view text) { return footprint_of(text, 0.0).fault; },
          .doc = doc};
}

}  // namespace bw
