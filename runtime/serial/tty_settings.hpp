// What is set on an open serial line. No call waits for the other end.
#pragma once

#include <cstdint>
#include <string>

namespace bw {

/// Raw, 8 data bits, no parity, 1 stop bit, no flow control, at any speed [bit/s] that the chip can make.
/// Returns what is wrong in words; empty: done.
std::string set_raw_line(int descriptor, std::int64_t baud);

/// Bytes are handed on at once, and closing waits for none; where the driver can and this user may.
void set_low_latency(int descriptor);

/// False where the line has no DTR.
bool set_dtr_line(int descriptor, bool is_set);

/// Lets what was written go out for at most 0.1 s, throws the rest away, closes. May take that long.
void drain_and_close(int descriptor);

}  // namespace bw
