// A client of Foxglove's protocol, for tests of a running viewer. It reads on a thread of its own, so that
// nothing is left out for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/page/load/web_client.hpp"

namespace bw::test {

/// Of the line `Page: http://127.0.0.1:PORT/?token=TOKEN` that a program prints.
struct PageAddress {
  std::uint16_t port = 0;  ///< 0: there is no such line
  std::string token;       ///< empty: the client may read
};
PageAddress page_in(const std::string& words);

class FoxgloveClient {
 public:
  using Bytes = std::vector<std::uint8_t>;
  struct Message {
    std::int64_t time = 0;  ///< [ns]
    Bytes cdr;
  };

  /// With `hears_everything` it subscribes to each channel as it comes.
  FoxgloveClient(const PageAddress& page, bool hears_everything);
  ~FoxgloveClient();
  FoxgloveClient(const FoxgloveClient&) = delete;
  FoxgloveClient& operator=(const FoxgloveClient&) = delete;

  // Each waits for what it needs, at most 30 s, and is false or empty when that did not come.
  bool has_channel(const std::string& topic);
  bool has_service(const std::string& service);
  bool subscribe(const std::string& topic);
  bool wait_for(const std::string& topic, std::size_t messages);
  /// The answer to a call in JSON; an object with `error` where it failed.
  nlohmann::json call(const std::string& service, const nlohmann::json& request);
  /// Values by name.
  std::map<std::string, nlohmann::json> set_parameter(const std::string& name, const nlohmann::json& value);
  /// A status whose message has these words.
  bool hears_status(const std::string& words);

  void advertise(std::uint32_t id, const std::string& topic, const std::string& type);
  void publish(std::uint32_t id, const nlohmann::json& message);

  bool is_closed() const { return is_closed_; }
  std::map<std::string, std::vector<Message>> messages() const;
  std::uint32_t channel_id(const std::string& topic) const;
  nlohmann::json info() const;
  double seconds() const;  ///< of the robot's clock, as it was told last

 private:
  void send(const nlohmann::json& op);
  void read();
  void take_text(const nlohmann::json& op);
  void take_binary(std::span<const std::uint8_t> bytes);
  void send_subscription(std::uint32_t channel);

  WebClient client_;
  const bool hears_everything_;
  mutable std::mutex mutex_;  ///< guards all that follows but the thread
  std::map<std::uint32_t, std::string> channels_;
  std::map<std::string, std::uint32_t> channel_of_;
  std::map<std::string, std::uint32_t> services_;
  std::map<std::string, std::vector<Message>> messages_;
  std::map<std::uint32_t, nlohmann::json> answers_;
  std::map<std::string, nlohmann::json> parameters_;  ///< answers by request
  std::vector<std::string> statuses_;
  nlohmann::json info_;
  std::int64_t time_ = 0;
  std::uint32_t calls_ = 0;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> is_closed_ = false;
  std::thread thread_;
};

}  // namespace bw::test
