// What is really published: a reader of our own for each topic, of which the server knows nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/dds/participant.hpp"

namespace bw::test {

class Published {
 public:
  /// Waits until every topic has a publisher; std::runtime_error after 30 s.
  explicit Published(const std::vector<std::string>& topics);

  /// Messages of a topic, in the order they were asked for, that came from `begin` on and before `end`
  /// (system clock).
  std::uint64_t count(std::size_t topic, Time begin, Time end);

 private:
  dds::Participant participant_;
  std::vector<std::unique_ptr<dds::Reader>> readers_;
  std::vector<std::vector<Time>> received_;
};

}  // namespace bw::test
