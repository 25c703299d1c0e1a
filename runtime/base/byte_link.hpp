// Bytes to and from a device, without waiting: what a driver and an emulator of hardware talk over. A serial
// port, a pseudo-terminal and a pair of topics are all one of these. Plain C++ only: algorithms include this
// header.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/base/time.hpp"

namespace bw {

struct LinkState {
  bool is_open = false;
  bool is_opening = false;     ///< not open yet, and nothing is wrong with that so far
  std::string device;          ///< as people name it: /dev/ttyUSB0
  std::string fault;           ///< why it is not open; empty while it is
  std::uint64_t openings = 0;  ///< so often it was opened: who sees a new number starts anew with the device
};

class ByteLink {
 public:
  virtual ~ByteLink() = default;
  /// Opens what is not open, at most once in a while; returns how it stands. To be called before each read.
  virtual const LinkState& update(Time now) = 0;
  /// What has come since the last call; valid until the next one. Empty while it is not open.
  virtual std::span<const std::uint8_t> read() = 0;
  /// False when the bytes were not taken whole: a part of them may be under way, and the link is closed if it
  /// is at fault.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
  /// The device was told to stand, and for a while nobody calls: a link that watches over this process takes
  /// that for no hang.
  virtual void rest() {}
  /// Gives the device up; the next update() may open it again. For a device that answers as another model.
  virtual void close(Time now, const std::string& why) = 0;
  /// The control line DTR of a serial port, after each opening; false where there is none (topics,
  /// emulators).
  virtual bool set_dtr(bool is_set) {
    static_cast<void>(is_set);
    return false;
  }
};

}  // namespace bw
