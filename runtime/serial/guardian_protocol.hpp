// What a port's guardian and the process that it guards say to each other: one byte a message, over a socket
// pair (SOCK_SEQPACKET).
#pragma once

#include <chrono>

namespace bw::guardian {

inline constexpr const char* kProgram = "bandwagon_port_guardian";  ///< beside the program that starts it

// What the guardian is started with.
inline constexpr int kSocket = 3;  ///< descriptor of its end of the pair
inline constexpr int kPort = 4;    ///< descriptor of the open port

// From the process.
inline constexpr char kHeartbeat = 'h';  ///< it lives; each is answered by kAnswer
inline constexpr char kRest =
    'r';  ///< the device was told to stand, and no heartbeat comes until it is used again
inline constexpr char kRelease = 'q';  ///< the port is given up: one last stop, and the guardian ends

// From the guardian.
inline constexpr char kAnswer = 'a';
inline constexpr char kTripped =
    't';  ///< no heartbeat in time: the device is told to stand until the port is given up

inline constexpr std::chrono::milliseconds kHeartbeatPeriod{20};
inline constexpr std::chrono::milliseconds kSilence{200};  ///< without a heartbeat: the process hangs
inline constexpr std::chrono::milliseconds kRepeat{50};    ///< between two stop frames
/// So often more after the process is gone; then the guardian ends.
inline constexpr int kLastWords = 3;
inline constexpr int kMaxUnanswered = 25;  ///< heartbeats, 0.5 s: the guardian hangs

}  // namespace bw::guardian
