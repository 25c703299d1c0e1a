// What success of a drive is, in every verb that counts it: `run`, `evaluate`, `score`, `bench` and
// `reproduce`.
#pragma once

#include <cstdint>

namespace bw {

/// In words, as in JSON.
inline constexpr const char* kSuccessMeans = "the goal is reached in time, without any contact";

/// Any contact counts, that of a robot that stands too: whose doing it was, and whether it could have been
/// avoided, is told beside it (`hits`, `possible`: possible/theory.md 8.10), and so is how many drives
/// reached the goal without a contact at speed.
constexpr bool is_success(bool reached, std::int64_t contacts) { return reached && contacts == 0; }

}  // namespace bw
