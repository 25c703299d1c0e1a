// Who commands the robot: the client whose command was the last. Where the server is open to a network there
// is one at a time, until it leaves or was silent for a while; on this machine's own loopback everybody may,
// and the last one is known all the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "runtime/base/time.hpp"
#include "runtime/remote/web/connection.hpp"

namespace bw::foxglove {

class Commander {
 public:
  /// `release_after`: so long after its last command nobody commands.
  Commander(bool is_one_at_a_time, Duration release_after)
      : is_one_at_a_time_(is_one_at_a_time), release_after_(release_after) {}

  bool is_one_at_a_time() const { return is_one_at_a_time_; }
  std::optional<web::ConnectionId> holder() const { return holder_; }

  /// False: another one commands. `now` by a clock that never goes back.
  bool take(web::ConnectionId who, Time now) {
    tick(now);
    if (is_one_at_a_time_ && holder_ && *holder_ != who) return false;
    holder_ = who;
    last_ = now;
    return true;
  }

  void leave(web::ConnectionId who) {
    if (holder_ == who) holder_.reset();
  }

  void tick(Time now) {
    if (holder_ && now - last_ >= release_after_) holder_.reset();
  }

 private:
  bool is_one_at_a_time_;
  Duration release_after_;
  std::optional<web::ConnectionId> holder_;
  Time last_;
};

/// Whether a service of this type changes nothing: it may be called by whoever may not command. By the names
/// of ROS 2's and Nav2's interfaces; of an action it is the question for a result.
bool only_asks(std::string_view service_type);

}  // namespace bw::foxglove
