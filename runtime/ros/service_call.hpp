// Calls of a ROS 2 service that wait for their replies: for programs of the command line. Components have
// Setup::client, which does not wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/service.hpp"

namespace bw {

/// The client's half of a service, for more calls than one.
class ServiceCaller {
 public:
  /// `on_news` runs on a DDS thread when something has come or changed: it may only wake somebody.
  ServiceCaller(dds::Participant& participant, const std::string& name, const ServiceType& type,
                const std::function<void()>& on_news);

  /// A server is there, in both directions.
  bool is_ready() const;
  /// The count of the request; nothing when DDS refused it.
  std::optional<std::int64_t> send(std::span<const std::uint8_t> request);
  /// The bytes of the reply to that request; nothing as long as there is none.
  std::optional<std::vector<std::uint8_t>> take(std::int64_t request);

 private:
  std::unique_ptr<dds::Reader> reader_;
  std::unique_ptr<dds::Writer> writer_;
  std::map<std::int64_t, std::vector<std::uint8_t>> replies_;
};

/// The reply's bytes; nothing when no server answered within `limit`.
std::optional<std::vector<std::uint8_t>> call_service(dds::Participant& participant, const std::string& name,
                                                      const ServiceType& type,
                                                      std::span<const std::uint8_t> request,
                                                      std::chrono::milliseconds limit);

template <class S>
std::optional<typename S::Response> call_service(dds::Participant& participant, const std::string& name,
                                                 const typename S::Request& request,
                                                 std::chrono::milliseconds limit) {
  std::vector<std::uint8_t> cdr;
  serialize(request, cdr);
  const auto reply = call_service(participant, name, service_type<S>(), cdr, limit);
  typename S::Response response;
  if (!reply || !deserialize(*reply, response)) return std::nullopt;
  return response;
}

}  // namespace bw
