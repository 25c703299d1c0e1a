// One client of one actor: writes requests, and gives the component their replies or tells it that none came.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/host/input_endpoint.hpp"
#include "runtime/host/timer.hpp"
#include "runtime/ports.hpp"

namespace bw {

class Runner;

class ClientEnd final : public InputEndpoint, public ClientPort {
 public:
  ClientEnd(Actor& owner, std::string declared, std::string resolved, const ServiceType& service_type,
            Need service_need);

  const std::string& label() const override { return service; }
  bool take_one(Time now, std::optional<Duration> waited) override;
  bool is_ready() const override;
  void call(std::span<const std::uint8_t> cdr, Duration deadline, ReplyHandler on_reply) override;

  /// Nobody waits for replies any more.
  void forget_calls();

  std::string name;     ///< as the component declared it
  std::string service;  ///< resolved, absolute
  ServiceType type;
  Need need;
  std::unique_ptr<dds::Reader> reader;
  std::unique_ptr<dds::Writer> writer;
  Runner* runner = nullptr;
  bool of_node = false;  ///< declared by the runtime, not by the component
  Timer deadline_timer;  ///< once, at the earliest deadline

 private:
  struct Call {
    std::vector<std::uint8_t> unsent;  ///< waits for a server; empty once it is written
    std::int64_t sequence = 0;         ///< of the written request
    Time deadline;
    ReplyHandler on_reply;
  };

  void send(Call& call);
  void expire(const Tick& tick);
  void watch_deadlines();

  std::map<std::uint64_t, Call> calls_;  ///< in their order
  std::uint64_t next_call_ = 0;
  dds::Sample sample_;
};

}  // namespace bw
