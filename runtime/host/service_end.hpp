// One service of one actor: takes requests, gives them to the component, writes replies as rmw_fastrtps does
// (identity in the inline QoS, nothing in the payload).
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/host/input_endpoint.hpp"
#include "runtime/host/statistics.hpp"
#include "runtime/ports.hpp"

namespace bw {

class SampleSink;

/// ROS 2's service introspection: `<service>/_service_event`.
inline constexpr const char* kServiceEvent = "/_service_event";

class ServiceEnd final : public InputEndpoint, public ServicePort {
 public:
  /// A request as it came.
  struct Request {
    RequestId from;
    std::vector<std::uint8_t> cdr;
  };

  ServiceEnd(Actor& owner, std::string declared, std::string resolved, const ServiceType& service_type,
             ServiceScope service_scope);

  const std::string& label() const override { return service; }
  bool calls_component() const override { return !off_lane; }
  bool is_off_lane() const override { return off_lane; }
  /// A request to the node waits while its component is busy, and does not make it so.
  bool takes_latency() const override { return scope == ServiceScope::component; }
  bool take_one(Time now, std::optional<Duration> waited) override;
  /// When the component's latency has passed; to a client that is not connected yet when it is, for at most a
  /// second.
  void reply(const RequestId& to, std::span<const std::uint8_t> cdr) override;
  /// Answers it here and now: by the component, or why not. A component that is not active changes nothing;
  /// one that is inactive still tells.
  void answer(const Request& request, Time now);
  void refuse(const RequestId& from, const std::string& reason);
  /// It changes something, so that in lock-step it may not come from outside.
  bool changes_something() const { return handler.refuse != nullptr; }

  /// In lock-step: requests of other participants wait apart, and here they are. From the runner's thread.
  std::vector<Request> take_foreign();
  /// Writes replies whose clients have been connected meanwhile.
  void flush();

  std::string name;     ///< as the component declared it
  std::string service;  ///< resolved, absolute
  ServiceType type;
  ServiceScope scope;
  RequestHandler handler;
  bool keeps_foreign_apart = false;  ///< lock-step
  bool off_lane = false;             ///< answered without the component, however busy it is
  bool of_node = false;              ///< declared by the runtime, not by the component
  std::function<void(const std::string& text)> complain;  ///< of requests that cannot be read
  std::unique_ptr<dds::Reader> reader;
  std::unique_ptr<dds::Writer> writer;
  SampleSink* sink = nullptr;
  CallbackStatistics statistics;

 private:
  struct Pending {
    RequestId to;
    std::vector<std::uint8_t> cdr;
    Duration since;  ///< steady time
  };

  bool is_closed() const;
  void sort_arrivals();
  void complain_of(const Request& request) const;
  void write(const RequestId& to, std::span<const std::uint8_t> cdr);

  std::uint64_t calls_ = 0;
  std::uint64_t refused_ = 0;  ///< because the component is not active
  dds::Sample sample_;
  std::deque<Request> own_;
  std::vector<Request> foreign_;
  std::mutex pending_mutex_;
  std::deque<Pending> pending_;
};

}  // namespace bw
