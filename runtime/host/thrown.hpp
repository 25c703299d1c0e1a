// What was thrown, for people.
#pragma once

#include <exception>
#include <string>

namespace bw {

/// Of the exception that is handled now.
inline std::string thrown_text() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "something that is no std::exception";
  }
}

}  // namespace bw
