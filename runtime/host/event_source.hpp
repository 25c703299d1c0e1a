// What happens in virtual time without any component of the run: the messages of a recording.
#pragma once

#include <optional>

#include "runtime/base/time.hpp"

namespace bw {

class EventSource {
 public:
  virtual ~EventSource() = default;
  /// When something happens next; nothing: never.
  virtual std::optional<Time> next() const = 0;
  /// Lets happen what is due. Called before the components' events of that instant.
  virtual void run(Time now) = 0;
};

}  // namespace bw
