#include "tests/page/load/load.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <poll.h>

#include "runtime/process_memory.hpp"
#include "tests/page/load/published.hpp"
#include "tests/page/load/web_client.hpp"

namespace bw::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kEverything = 65536;

Time now() {
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(
              std::chrono::system_clock::now().time_since_epoch())
              .count()};
}

/// Message data, as the protocol lays it out: opcode 1, subscription, log time, payload; little endian.
struct Update {
  std::size_t topic = 0;
  Time logged;
};
std::optional<Update> update_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 13 || bytes[0] != 1) return std::nullopt;
  std::uint32_t subscription = 0;
  std::int64_t logged = 0;
  std::memcpy(&subscription, bytes.data() + 1, sizeof subscription);
  std::memcpy(&logged, bytes.data() + 5, sizeof logged);
  return Update{subscription - 1, {logged}};
}

/// What a client is told of the channels, until it knows those of `topics`.
std::vector<std::uint32_t> channels_of(std::uint16_t port, const std::vector<std::string>& topics) {
  WebClient scout(port);
  std::map<std::string, std::uint32_t> ids;
  const auto known = [&] {
    return std::ranges::all_of(topics, [&](const std::string& t) { return ids.contains(t); });
  };
  for (const auto end = Clock::now() + std::chrono::seconds(30); !known();) {
    if (Clock::now() > end)
      throw std::runtime_error("the server does not offer every topic that was asked for");
    pollfd waiting{.fd = scout.descriptor(), .events = POLLIN, .revents = 0};
    ::poll(&waiting, 1, 100);
    const bool is_open = scout.receive(kEverything, [&](bool is_text, std::span<const std::uint8_t> payload) {
      if (!is_text) return;
      const auto message = nlohmann::json::parse(payload.begin(), payload.end());
      if (message.value("op", "") != "advertise") return;
      for (const auto& channel : message["channels"]) ids[channel["topic"]] = channel["id"];
    });
    if (!is_open) throw std::runtime_error("the server closed the connection");
  }
  std::vector<std::uint32_t> channels;
  for (const std::string& topic : topics) channels.push_back(ids[topic]);
  return channels;
}

class Load {
 public:
  explicit Load(const LoadOptions& options)
      : options_(options),
        channels_(channels_of(options.port, options.topics)),
        subscribe_(subscribe_to(channels_)) {}

  LoadResult run() {
    Published published(options_.topics);
    const double memory_before = memory_mb(std::to_string(options_.robot));
    for (int i = 0; i < options_.healthy; ++i) healthy_.push_back(connect_one());
    for (int i = 0; i < options_.slow; ++i) slow_.push_back(connect_slow());
    counts_.assign(healthy_.size(), std::vector<std::uint64_t>(options_.topics.size()));
    begin_ = now() + Duration::milliseconds(500);  // until the subscriptions have reached the server
    end_ = begin_ + Duration::seconds(options_.seconds);
    flapping_.resize(static_cast<std::size_t>(options_.flapping));
    // What was published shortly before the end is on its way for a moment.
    for (const Time last = end_ + Duration::milliseconds(1000); now() < last;) {
      read_healthy();
      read_slow();
      flap();
    }
    return result(published, memory_before);
  }

 private:
  WebClient connect_one(int receive_buffer = 0) {
    WebClient client(options_.port, receive_buffer);
    client.send_text(subscribe_);
    return client;
  }

  /// Its window fills at once, so that what is sent waits in the server.
  WebClient connect_slow() {
    WebClient client = connect_one(4096);
    for (bool is_subscribed = false; !is_subscribed;) {
      pollfd waiting{.fd = client.descriptor(), .events = POLLIN, .revents = 0};
      if (::poll(&waiting, 1, 10'000) != 1) throw std::runtime_error("no answer from the server");
      if (!client.receive(256, [](bool, std::span<const std::uint8_t>) {}))
        throw std::runtime_error("the server closed a slow client at once");
      is_subscribed = client.is_open();
    }
    return client;
  }

  void read_healthy() {
    std::vector<pollfd> waiting;
    for (const auto& client : healthy_)
      waiting.push_back({.fd = client ? client->descriptor() : -1, .events = POLLIN, .revents = 0});
    ::poll(waiting.data(), waiting.size(), 5);
    for (std::size_t i = 0; i < healthy_.size(); ++i) {
      if (waiting[i].revents == 0) continue;
      const Time arrival = now();
      const bool is_open =
          healthy_[i]->receive(kEverything, [&](bool, std::span<const std::uint8_t> payload) {
            const auto update = update_of(payload);
            if (!update || update->topic >= options_.topics.size() || update->logged < begin_ ||
                update->logged >= end_)
              return;
            ++counts_[i][update->topic];
            delays_ms_.push_back(static_cast<float>((arrival - update->logged).to_seconds() * 1e3));
          });
      if (is_open) continue;
      healthy_[i].reset();
      ++healthy_closed_;
    }
  }

  void read_slow() {
    if (Clock::now() < next_slow_) return;
    next_slow_ += std::chrono::seconds(1);
    for (auto& client : slow_) {
      if (client && !client->receive(1, [](bool, std::span<const std::uint8_t>) {})) client.reset();
    }
  }

  void flap() {
    if (Clock::now() < next_flap_) return;
    next_flap_ += std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(1 / options_.flaps_per_second));
    for (auto& client : flapping_) {
      try {
        if (client)
          client->receive(kEverything, [](bool, std::span<const std::uint8_t>) {});  // which subscribes
        if (client && flaps_ % 2 == 0) client->end_by_reset();
        client.reset();
        client.emplace(connect_one());
        ++flaps_;
      } catch (const std::runtime_error&) {
        ++refused_;  // so many a second are not let in
        client.reset();
      }
    }
  }

  LoadResult result(Published& published, double memory_before) {
    LoadResult result{.healthy_closed = healthy_closed_, .flaps = flaps_, .flaps_refused = refused_};
    for (std::size_t topic = 0; topic < options_.topics.size(); ++topic) {
      TopicLoad load{.topic = options_.topics[topic],
                     .published = published.count(topic, begin_, end_),
                     .worst_share = 1};
      for (const auto& counts : counts_) {
        const double share = static_cast<double>(counts[topic]) /
                             static_cast<double>(std::max<std::uint64_t>(load.published, 1));
        load.worst_share = std::min(load.worst_share, share);
        load.mean_share += share / static_cast<double>(counts_.size());
        result.received += counts[topic];
      }
      result.topics.push_back(load);
    }
    std::ranges::sort(delays_ms_);
    if (!delays_ms_.empty()) {
      const auto quantile = [this](double q) {
        return delays_ms_[static_cast<std::size_t>(q * static_cast<double>(delays_ms_.size() - 1))];
      };
      result.delay_ms_p50 = quantile(0.5);
      result.delay_ms_p99 = quantile(0.99);
      result.delay_ms_max = quantile(1);
    }
    result.memory_mb = memory_mb(std::to_string(options_.robot), "VmHWM") - memory_before;
    return result;
  }

  LoadOptions options_;
  std::vector<std::uint32_t> channels_;
  std::string subscribe_;
  Time begin_, end_;
  std::vector<std::optional<WebClient>> healthy_, slow_, flapping_;
  std::vector<std::vector<std::uint64_t>> counts_;  // of the healthy ones, by topic
  std::vector<float> delays_ms_;
  int healthy_closed_ = 0;
  std::uint64_t flaps_ = 0;
  std::uint64_t refused_ = 0;
  Clock::time_point next_slow_ = Clock::now(), next_flap_ = Clock::now();
};

}  // namespace

LoadResult put_load(const LoadOptions& options) { return Load(options).run(); }

nlohmann::json to_json(const LoadResult& result) {
  nlohmann::json topics = nlohmann::json::array();
  for (const TopicLoad& load : result.topics) {
    topics.push_back({{"topic", load.topic},
                      {"published", load.published},
                      {"worst_share", load.worst_share},
                      {"mean_share", load.mean_share}});
  }
  return {{"topics", topics},
          {"received", result.received},
          {"delay_ms",
           {{"p50", result.delay_ms_p50}, {"p99", result.delay_ms_p99}, {"max", result.delay_ms_max}}},
          {"healthy_closed", result.healthy_closed},
          {"flaps", result.flaps},
          {"flaps_refused", result.flaps_refused},
          {"memory_mb", result.memory_mb}};
}

}  // namespace bw::test
