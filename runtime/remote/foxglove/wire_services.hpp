// The services of a domain, and calls of them that do not wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/foxglove/wire_link.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::foxglove {

class WireServices {
 public:
  /// Gets the bytes of the reply, or what went wrong. Comes once, never within the call itself.
  using OnReply = std::function<void(const std::variant<Bytes, std::string>& reply_or_error)>;
  struct Offer {
    Service service;
    const TypeDescription* request = nullptr;
    const TypeDescription* response = nullptr;
    std::set<dds::Guid> servers;  ///< their readers of requests
  };

  explicit WireServices(WireLink& link);

  /// What others offer.
  void look(const std::vector<dds::Endpoint>& endpoints);
  /// Ends calls whose time is over, and what nobody has called for a while.
  void tick(std::chrono::steady_clock::time_point now);
  bool is_busy() const { return !callers_.empty(); }

  std::vector<Service> services() const;
  const std::map<std::uint32_t, Offer>& offers() const { return offers_; }
  /// Null where nobody offers it.
  const Offer* find(std::uint32_t service) const;
  const Offer* find(const std::string& name) const;
  void call(std::uint32_t service, std::span<const std::uint8_t> request, OnReply on_reply);

 private:
  struct Call {
    std::vector<std::uint8_t> request;
    OnReply on_reply;
    std::chrono::steady_clock::time_point deadline;
    std::optional<std::int64_t> sent;
  };
  struct Caller {
    std::string service;
    const TypeDescription* response = nullptr;
    std::unique_ptr<ServiceCaller> ends;
    std::vector<Call> calls;
    std::chrono::steady_clock::time_point used;
  };
  using Answer = std::pair<OnReply, std::variant<Bytes, std::string>>;

  std::optional<Offer> offer_of(const std::string& name, const dds::Endpoint& server,
                                const std::vector<dds::Endpoint>& endpoints);
  Caller& caller_of(const Offer& offer);
  void hear();
  void give(std::vector<Answer> answers);
  void answer_later(OnReply on_reply, std::string error);

  WireLink& link_;
  std::map<std::pair<std::string, const TypeDescription*>, std::uint32_t> ids_;
  std::map<std::uint32_t, Offer> offers_;
  std::map<std::string, std::uint32_t> id_of_;  ///< by name
  std::map<const TypeDescription*, std::string> schemas_;
  std::set<std::string> told_;  ///< types that are not known
  std::map<std::uint32_t, Caller> callers_;
  std::vector<Answer> refused_;  ///< answers that wait for their turn
  PostedTask hearing_;
};

}  // namespace bw::foxglove
