// A Foxglove server: the protocol between clients' sockets and a robot, and what is kept of each client. No
// sockets, DDS, threads or clocks of its own. All calls come on one thread; neither the sender nor the
// robot's answers need to wait for anything.
//
// Per client: channels and services are announced in batches; one subscription a channel; latched messages
// are sent again to each new subscription; times go before the messages they belong to; data may be left out
// for the slow (web::Keep), answers are not. Commands are publishing, setting parameters and calls of
// services that change something; who may not command is told why, and may read.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/remote/foxglove/client.hpp"
#include "runtime/remote/foxglove/commander.hpp"
#include "runtime/remote/foxglove/published_topics.hpp"
#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/foxglove/server_ops.hpp"
#include "runtime/remote/web/connection.hpp"

namespace bw::foxglove {

struct ServerOptions {
  std::string name = "Bandwagon";
  std::string session;  ///< tells clients that the server is another one than before: different in each run
  bool is_one_commander =
      false;  ///< one client commands at a time: where others than those of this machine may
  Duration commander_release =
      Duration::milliseconds(10'000);  ///< after its last command it is the next one's turn
  Duration time_period =
      Duration::milliseconds(10);  ///< a client is told the time no more often, but for a time that went back
  std::size_t batch = 100;         ///< channels or services in one announcement
  std::size_t most_calls = 32;     ///< of services in flight, of one client; as many requests for parameters
  std::size_t most_channels = 256;  ///< on which one client publishes
  std::size_t kept_notices = 32;    ///< of the robot's notices, for clients that come later
  /// The file of a URI, or why there is none. Null: `assets` is not offered and every request refused.
  std::function<std::variant<Bytes, std::string>(const std::string& uri)> assets;
};

class Server final : public web::SocketHandler, public RobotListener {
 public:
  /// Monotonic; its zero does not matter.
  using Clock = std::function<Time()>;
  /// Id of the status that says to a client why it may not command.
  static constexpr const char* kReadOnlyStatus = "read_only";
  /// Id of the status that says who commands. Level 0: this client does, or may; 1: another one does, and
  /// this one would be refused.
  static constexpr const char* kCommanderStatus = "commander";

  /// Listens to the robot from now on; both must outlive it.
  Server(web::SocketSender& sender, Robot& robot, ServerOptions options, Clock clock);
  ~Server() override;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// About ten times a second: the time to those who get no messages, and the end of a commander's turn.
  void tick();

  void on_open(web::ConnectionId id, const web::Opening& opening) override;
  void on_text(web::ConnectionId id, std::string_view text) override;
  void on_binary(web::ConnectionId id, std::span<const std::uint8_t> bytes) override;
  void on_close(web::ConnectionId id) override;

  void on_channels(const std::vector<Channel>& added, const std::vector<std::uint32_t>& removed) override;
  void on_services(const std::vector<Service>& added, const std::vector<std::uint32_t>& removed) override;
  void on_message(std::uint32_t channel, Time received, const SharedBytes& cdr) override;
  void on_time(Time now) override;
  void on_graph() override;
  void on_parameters(const std::vector<NamedValue>& changed) override;
  void on_status(int level, const std::string& message) override;

 private:
  struct Heard {
    Channel channel;
    std::map<web::ConnectionId, std::uint32_t> subscriptions;  ///< one of a client
  };
  struct Notice {
    Level level = Level::info;
    std::string message;
  };

  void handle(Client& client, const Subscribe& op);
  void handle(Client& client, const Unsubscribe& op);
  void handle(Client& client, const Advertise& op);
  void handle(Client& client, const Unadvertise& op);
  void handle(Client& client, const GetParameters& op);
  void handle(Client& client, const SetParameters& op);
  void handle(Client& client, const SubscribeParameterUpdates& op);
  void handle(Client& client, const UnsubscribeParameterUpdates& op);
  void handle(Client& client, const SubscribeConnectionGraph& op);
  void handle(Client& client, const UnsubscribeConnectionGraph& op);
  void handle(Client& client, const FetchAsset& op);
  void handle(Client& client, const Publish& op);
  void handle(Client& client, const CallService& op);
  void handle(Client& client, const PlaybackControl& op);

  ServerInfo info_for(const Client& client) const;
  Client* find(web::ConnectionId id);
  void send(const Client& client, web::Frame frame) { sender_.send(client.id, std::move(frame), {}); }
  void say(const Client& client, Level level, const std::string& message, const std::string& id = "");
  void send_to_all(const web::Frame& frame);

  /// Tells the time where it has changed and is due.
  void tell_time(Client& client);
  void send_message(Client& client, std::uint32_t subscription, Time time, const SharedBytes& cdr,
                    web::Keep keep);
  void replay_latched(Client& client, const Heard& heard, std::uint32_t subscription);
  void forget_subscriptions(const Heard& heard);

  const std::vector<web::Frame>& channel_frames();
  const std::vector<web::Frame>& service_frames();

  /// Why this client may not command now; where it may, it is the commander.
  std::optional<std::string> take_command(const Client& client);
  void tell_commander();
  void tell_commander(const Client& client);

  /// Why not: unknown, or too many.
  std::optional<std::string> refuse_call(const Client& client, const CallService& op) const;
  void answer_call(web::ConnectionId id, std::uint32_t service, std::uint32_t call, std::string_view encoding,
                   const std::variant<Bytes, std::string>& reply);
  bool begin_parameter_request(Client& client);
  Robot::Values answer_parameters(const Client& client, const std::optional<std::string>& request,
                                  bool is_asked);

  web::SocketSender& sender_;
  Robot& robot_;
  const ServerOptions options_;
  const Clock clock_;
  /// What the robot answers after this server's end finds it gone.
  std::shared_ptr<Server*> self_ = std::make_shared<Server*>(this);

  std::map<web::ConnectionId, Client> clients_;
  std::map<std::uint32_t, Heard> channels_;
  std::map<std::uint32_t, Service> services_;
  std::optional<std::vector<web::Frame>> channel_frames_;  ///< unset: to be made again
  std::optional<std::vector<web::Frame>> service_frames_;
  PublishedTopics published_topics_;
  Commander commander_;
  std::optional<web::ConnectionId> told_commander_;
  std::shared_ptr<const ConnectionGraph> graph_;  ///< null while nobody asked
  std::optional<Time> time_;                      ///< the robot's
  std::deque<Notice> notices_;
};

}  // namespace bw::foxglove
