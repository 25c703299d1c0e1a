// That the base stands and obeys nobody, and why.
#pragma once

#include <string>

namespace bw {

struct BaseStop {
  std::string reason;       ///< the base's own, for people
  bool is_latched = false;  ///< it takes a release
  bool operator==(const BaseStop&) const = default;
};

inline std::string in_words(const BaseStop& stop) {
  return "the base stands: " + stop.reason + (stop.is_latched ? "; until release_stop" : "");
}

}  // namespace bw
