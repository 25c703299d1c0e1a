// The host's end of a serial cable: a tty, for this process alone. Opening, closing and control lines go
// through a thread of the port's own, so that no call waits for a device, not even for one that hangs; bytes
// are read and written at once or not at all.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/byte_link.hpp"
#include "runtime/serial/background_jobs.hpp"
#include "runtime/serial/port_options.hpp"
#include "runtime/serial/system_folders.hpp"

namespace bw {

class SerialPort final : public ByteLink {
 public:
  /// Opens nothing yet. `name` is for people where the port's own says little. A device that is not there is
  /// no fault for so long as `patience` since the first update(), and is looked for more often: who makes it
  /// may only be starting.
  explicit SerialPort(PortOptions options, std::string name = {}, Duration patience = {},
                      SystemFolders folders = {});
  /// Bytes written before still go out, for 0.1 s at most.
  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Tries to open at most every 0.5 s; a result shows in a later call. A line that was hung up or removed is
  /// seen here or by read().
  const LinkState& update(Time now) override;
  std::span<const std::uint8_t> read() override;
  bool write(std::span<const std::uint8_t> bytes) override;
  void close(Time now, const std::string& why) override;
  bool set_dtr(bool is_set) override;
  /// Of the open line; -1: it is not open.
  int descriptor() const { return descriptor_; }

 private:
  struct Attempt;
  void look_at_attempt(Time now);
  bool is_patient(Time now) const;
  void begin_attempt(Time now);
  void lose(const std::string& why);
  void give_up_descriptor();

  PortOptions options_;
  std::string name_;
  Duration patience_;
  SystemFolders folders_;
  LinkState state_;
  int descriptor_ = -1;
  std::optional<Time> first_update_;
  std::optional<Time> tried_;  ///< the last time, or when it was closed
  std::shared_ptr<Attempt> attempt_;
  std::vector<std::uint8_t> buffer_;
  BackgroundJobs jobs_;
};

}  // namespace bw
