// What the server keeps of one client.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/remote/foxglove/client_ops.hpp"
#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/web/connection.hpp"

namespace bw::foxglove {

/// Of which parameters a client wants to hear: some, or all but some.
class ParameterInterest {
 public:
  /// More names are not kept; false.
  static constexpr std::size_t kMaxNames = 20'000;

  bool add(const std::vector<std::string>& names) {
    if (names.empty()) *this = ParameterInterest(true);
    return change(names, !is_all_);
  }
  bool remove(const std::vector<std::string>& names) {
    if (names.empty()) *this = ParameterInterest(false);
    return change(names, is_all_);
  }
  bool wants(const std::string& name) const { return is_all_ != names_.contains(name); }
  bool wants_all() const { return is_all_ && names_.empty(); }

  ParameterInterest() = default;

 private:
  explicit ParameterInterest(bool is_all) : is_all_(is_all) {}

  bool change(const std::vector<std::string>& names, bool is_put) {
    for (const std::string& name : names) {
      if (!is_put)
        names_.erase(name);
      else if (names_.size() < kMaxNames)
        names_.insert(name);
      else
        return false;
    }
    return true;
  }

  bool is_all_ = false;
  std::set<std::string> names_;  ///< those wanted; where all are, those not
};

struct Client {
  web::ConnectionId id = 0;
  web::Opening opening;
  Subprotocol subprotocol = Subprotocol::sdk_v1;
  std::map<std::uint32_t, std::uint32_t> subscriptions;  ///< the channel of each
  std::map<std::uint32_t, ClientChannel> published;
  ParameterInterest interest;
  std::set<std::pair<std::uint32_t, std::uint32_t>> calls;  ///< service and call id of those in flight
  int parameter_requests = 0;                               ///< in flight
  std::shared_ptr<const ConnectionGraph> graph;             ///< as last told; null: not asked for
  std::optional<Time> told_time;                            ///< the robot's, as last told
  Time told_at;                                             ///< on the server's clock
};

}  // namespace bw::foxglove
