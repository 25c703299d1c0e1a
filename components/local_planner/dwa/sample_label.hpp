// How a sample is called where candidates are shown.
#pragma once

#include <cstdio>
#include <string>

#include "runtime/base/pose2.hpp"

namespace bw::dwa {

inline std::string label_of(const Twist2& twist) {
  char text[48];
  std::snprintf(text, sizeof text, "v %.2f w %.2f", twist.v, twist.omega);
  return text;
}

}  // namespace bw::dwa
