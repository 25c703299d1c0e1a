// What the operating system gives a thread that must not wait for others: a real-time priority, and memory
// that stays where it is.
#pragma once

#include <string>

namespace bw {

/// First come, first served, before all threads without such a priority. For the calling thread. Empty when
/// it was given, else why not and what to do.
std::string take_real_time_priority();

/// Keeps what this process touches in memory. Empty when it is so, else why not and what to do.
std::string lock_memory();

/// Whether this user may have both: empty, or as above. Changes nothing.
std::string missing_real_time_rights();

}  // namespace bw
