// The device's end of an emulated serial cable: the master of a pseudo-terminal, and a link by which the host
// finds the other end.
// The link goes through the process that made it (/proc/PID/root/dev/pts/N): when that is gone it leads
// nowhere, and never to a terminal that got the number since.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/byte_link.hpp"

namespace bw {

class PseudoTerminal final : public ByteLink {
 public:
  /// Plugs nothing in yet.
  explicit PseudoTerminal(std::filesystem::path link);
  ~PseudoTerminal() override;
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Plugs the cable in where it is not. `is_open`: it is plugged in, whether or not the host listens.
  /// Refused, in `fault`, while another living process has the link.
  const LinkState& update(Time now) override;
  std::span<const std::uint8_t> read() override;
  /// A device sends whether or not somebody listens: bytes for nobody are lost, and taken. False when the
  /// host reads so slowly that they do not fit.
  bool write(std::span<const std::uint8_t> bytes) override;
  /// Pulls the cable: the host sees its line hung up. The next update() puts it back.
  void close(Time now, const std::string& why) override;
  void pull() { close({}, "cable pulled"); }

 private:
  void plug_in();
  bool place_link();
  std::string target() const;

  std::filesystem::path link_;
  LinkState state_;
  int master_ = -1;
  std::string slave_;  ///< /dev/pts/N
  std::vector<std::uint8_t> buffer_;
};

}  // namespace bw
