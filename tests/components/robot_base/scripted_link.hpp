// A cable without a device: tests put in what is read and look at what was written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/byte_link.hpp"

namespace bw {

using Bytes = std::vector<std::uint8_t>;

inline Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

class ScriptedLink final : public ByteLink {
 public:
  /// What both ends share: a driver owns its link.
  struct Wire {
    Bytes to_host;                 ///< read at the next read()
    std::vector<Bytes> from_host;  ///< one per write()
    LinkState state{.is_open = true, .device = "/dev/tested", .fault = {}, .openings = 1};
    bool refuses = false;  ///< to write
    std::string closed_because;

    void put(std::span<const std::uint8_t> bytes) {
      to_host.insert(to_host.end(), bytes.begin(), bytes.end());
    }
    void put(std::string_view text) { put(bytes_of(text)); }
    void pull() { state.is_open = false, state.fault = "gone"; }
    void plug_in() { state.is_open = true, state.fault = {}, ++state.openings; }
  };

  explicit ScriptedLink(Wire& wire) : wire_(wire) {}
  const LinkState& update(Time) override { return wire_.state; }
  std::span<const std::uint8_t> read() override {
    read_ = std::exchange(wire_.to_host, {});
    if (!wire_.state.is_open) read_.clear();
    return read_;
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    if (!wire_.state.is_open || wire_.refuses) return false;
    wire_.from_host.emplace_back(bytes.begin(), bytes.end());
    return true;
  }
  void close(Time, const std::string& why) override {
    wire_.closed_because = why;
    wire_.pull();
  }

 private:
  Wire& wire_;
  Bytes read_;
};

}  // namespace bw
