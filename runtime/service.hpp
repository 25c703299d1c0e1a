// The two ends of a service as components see them. Neither blocks: a reply is given now or later, and comes
// as a call.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/ports.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {

/// Answers one request, once: now, in a later callback of the same component, or where time is real from a thread that
/// this has started. A copyable handle.
template <class S>
class Reply {
 public:
  Reply() = default;
  Reply(ServicePort* port, const RequestId& to) : port_(port), to_(to) {}

  void operator()(const typename S::Response& response) const {
    std::vector<std::uint8_t> cdr;
    serialize(response, cdr);
    port_->reply(to_, cdr);
  }

 private:
  ServicePort* port_ = nullptr;
  RequestId to_;
};

/// What a service that changes something answers where it may not. It outlives the component that gave it:
/// nothing of that is captured in it.
template <class S>
using Refusal = std::function<typename S::Response(const std::string& reason)>;

/// Calls a service. A copyable handle; valid from configure() on.
template <class S>
class Client {
 public:
  using OnResponse = std::function<void(const typename S::Response* response, const Tick& tick)>;

  Client() = default;
  explicit Client(ClientPort* port) : port_(port) {}

  /// A server is there.
  bool is_ready() const { return port_->is_ready(); }
  /// `on_response` is called once, as a callback of the component: with null when no server answered within
  /// `deadline` of the component clock. A request waits so long for its server.
  void call(const typename S::Request& request, Duration deadline, OnResponse on_response) const {
    std::vector<std::uint8_t> cdr;
    serialize(request, cdr);
    port_->call(cdr, deadline,
                [on_response = std::move(on_response)](std::optional<std::span<const std::uint8_t>> reply,
                                                       const Tick& tick) {
                  typename S::Response response;
                  const bool came = reply && deserialize(*reply, response);
                  on_response(came ? &response : nullptr, tick);
                });
  }

 private:
  ClientPort* port_ = nullptr;
};

template <class S>
ServiceType service_type() {
  const auto message = []<class M>(std::type_identity<M>) {
    return MessageType{MessageTraits<M>::ros_name, MessageTraits<M>::dds_name, MessageTraits<M>::type_hash};
  };
  return {.ros_name = S::ros_name,
          .request = message(std::type_identity<typename S::Request>{}),
          .response = message(std::type_identity<typename S::Response>{}),
          .event = message(std::type_identity<typename S::Event>{})};
}

/// The message under which a request is recorded, as ROS 2's service introspection has it; false when the
/// bytes do not hold the request.
template <class S>
bool event_of_request(std::span<const std::uint8_t> request_cdr, const RequestId& from, Time now,
                      std::vector<std::uint8_t>& event_cdr) {
  constexpr std::uint8_t kRequestReceived = 1;
  typename S::Request request;
  if (!deserialize(request_cdr, request)) return false;
  typename S::Event event;
  event.info().event_type(kRequestReceived);
  event.info().stamp(to_stamp(now));
  event.info().client_gid(from.client);
  event.info().sequence_number(from.sequence);
  event.request().push_back(std::move(request));
  serialize(event, event_cdr);
  return true;
}

template <class S>
bool request_of_event(std::span<const std::uint8_t> event_cdr, RequestId& from,
                      std::vector<std::uint8_t>& request_cdr) {
  typename S::Event event;
  if (!deserialize(event_cdr, event) || event.request().size() != 1) return false;
  from = {event.info().client_gid(), event.info().sequence_number()};
  serialize(event.request().front(), request_cdr);
  return true;
}

/// `handle(request, tick)` returns the response; or `handle(request, reply, tick)` sees to it that `reply` is
/// called.
template <class S, class Handle>
RequestHandler request_handler(ServicePort& port, Handle handle, Refusal<S> refuse) {
  RequestHandler result;
  result.handle = [&port, handle = std::move(handle)](std::span<const std::uint8_t> cdr,
                                                      const RequestId& from, const Tick& tick) mutable {
    typename S::Request request;
    if (!deserialize(cdr, request)) return false;
    const Reply<S> reply(&port, from);
    if constexpr (std::is_invocable_v<Handle&, const typename S::Request&, const Tick&>) {
      reply(handle(std::as_const(request), tick));
    } else {
      handle(std::as_const(request), reply, tick);
    }
    return true;
  };
  result.empty = [](std::vector<std::uint8_t>& cdr) { serialize(typename S::Response(), cdr); };
  if (refuse) {
    result.refuse = [refuse = std::move(refuse)](const std::string& reason, std::vector<std::uint8_t>& cdr) {
      serialize(refuse(reason), cdr);
    };
    result.to_event = event_of_request<S>;
    result.from_event = request_of_event<S>;
  }
  return result;
}

}  // namespace bw
