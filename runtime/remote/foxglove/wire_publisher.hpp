// What clients publish, on writers of this participant's own.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/remote/foxglove/wire_link.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::foxglove {

class WirePublisher {
 public:
  /// Non-empty `refusal`: nothing is published, and that is why.
  WirePublisher(WireLink& link, std::string refusal);

  // Each says what is wrong, or nothing.
  std::optional<std::string> advertise(const std::string& topic, const std::string& type);
  std::optional<std::string> publish(const std::string& topic, std::span<const std::uint8_t> cdr);
  std::optional<std::string> publish_json(const std::string& topic, std::string_view json);

  /// Counted: as often as it was advertised.
  void unadvertise(const std::string& topic);
  /// Writes what waited for readers long enough; closes what nobody advertises any more.
  void tick(std::chrono::steady_clock::time_point now);
  bool is_busy() const;

 private:
  struct Topic {
    const TypeDescription* type = nullptr;
    int advertised = 0;
    std::unique_ptr<dds::Writer> writer;
    std::chrono::steady_clock::time_point opened;
    std::chrono::steady_clock::time_point unwanted_since;
    /// Who has just been advertised has no reader yet: what it says first waits for those that are there.
    std::vector<std::vector<std::uint8_t>> waiting;
  };

  std::optional<std::string> open(const std::string& topic, const std::string& type);
  bool has_readers(const std::string& topic, const Topic& one);
  void flush();

  WireLink& link_;
  const std::string refusal_;
  std::map<std::string, Topic> topics_;
  PostedTask flushing_;
};

}  // namespace bw::foxglove
