// What discovery has told: the participants and endpoints that are there, and the writers that were.
#pragma once

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "runtime/dds/fast_values.hpp"

namespace bw::dds {

inline Endpoint to_endpoint(const fast_dds::DiscoveredEndpoint& data) {
  Endpoint e;
  e.guid = to_guid(data.guid);
  e.is_writer = data.is_writer;
  e.topic = data.topic;
  e.type = data.type;
  e.qos.reliability =
      data.reliability == efd::RELIABLE_RELIABILITY_QOS ? Reliability::reliable : Reliability::best_effort;
  e.qos.durability = data.durability >= efd::TRANSIENT_LOCAL_DURABILITY_QOS ? Durability::transient_local
                                                                            : Durability::volatile_;
  if (!fast_dds::is_infinite(data.lifespan)) e.qos.lifespan = Duration{data.lifespan.to_ns()};
  e.user_data = data.user_data;
  e.partitions = data.partitions;
  return e;
}

/// Keeps the table of remote participants and endpoints.
class DiscoveryListener final : public fast_dds::DiscoveryEvents {
 public:
  void on_participant(const rtps::GUID_t& id, const fast_dds::Duration& lease,
                      fast_dds::Presence presence) override {
    const Guid guid = to_guid(id);
    const std::lock_guard lock(mutex_);
    if (presence != fast_dds::Presence::here) {
      participants_.erase(guid);
      std::erase_if(endpoints_, [&](const auto& item) {
        const bool is_its = same_participant(guid, item.first);
        if (is_its) remember(item.second);
        return is_its;
      });
      ++changes_;
    } else {
      participants_[guid] = Duration{lease.to_ns()};
    }
  }
  void on_endpoint(const fast_dds::DiscoveredEndpoint& endpoint, fast_dds::Presence presence) override {
    update(to_endpoint(endpoint), presence != fast_dds::Presence::here);
  }

  void add_local(Endpoint endpoint) {
    endpoint.is_local = true;
    update(endpoint, false);
  }
  void remove_local(const Guid& guid) {
    const std::lock_guard lock(mutex_);
    endpoints_.erase(guid);
    ++changes_;
  }
  std::uint64_t changes() const { return changes_; }
  std::vector<Endpoint> endpoints() const {
    std::vector<Endpoint> all;
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [guid, endpoint] : endpoints_) all.push_back(endpoint);
    }
    std::ranges::sort(all, [](const Endpoint& a, const Endpoint& b) {
      return std::tie(a.topic, a.is_writer, a.guid) < std::tie(b.topic, b.is_writer, b.guid);
    });
    return all;
  }
  std::vector<Endpoint> take_departed() {
    const std::lock_guard lock(mutex_);
    return std::exchange(departed_, {});
  }
  std::optional<Duration> lease_of(const Guid& endpoint) const {
    const std::lock_guard lock(mutex_);
    if (!endpoints_.contains(endpoint)) return std::nullopt;
    const auto its = std::ranges::find_if(
        participants_, [&](const auto& one) { return same_participant(one.first, endpoint); });
    return its == participants_.end() ? std::nullopt : std::optional(its->second);
  }
  std::vector<Guid> participants() const {
    const std::lock_guard lock(mutex_);
    std::vector<Guid> all;
    for (const auto& [guid, lease] : participants_) all.push_back(guid);
    return all;
  }

 private:
  void update(const Endpoint& endpoint, bool removed) {
    const std::lock_guard lock(mutex_);
    if (removed) {
      if (endpoints_.erase(endpoint.guid) > 0) remember(endpoint);
    } else {
      endpoints_[endpoint.guid] = endpoint;
    }
    ++changes_;
  }
  /// With the mutex held.
  void remember(const Endpoint& endpoint) {
    constexpr std::size_t kMax = 256;
    if (endpoint.is_writer && departed_.size() < kMax) departed_.push_back(endpoint);
  }

  std::atomic<std::uint64_t> changes_ = 0;
  mutable std::mutex mutex_;
  std::map<Guid, Duration> participants_;  ///< with their leases
  std::map<Guid, Endpoint> endpoints_;
  std::vector<Endpoint> departed_;
};

}  // namespace bw::dds
