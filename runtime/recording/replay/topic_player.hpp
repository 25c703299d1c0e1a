// Plays a bag as topics in real time: the recorded bytes under the recorded names, types and offers, as a
// node of its own, `bandwagon_player`. What latched writers had said before the beginning is published first.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/replay/play_schedule.hpp"
#include "runtime/recording/replay/played_topics.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::replay {

struct PlayerOptions {
  TopicSelection selection;
  dds::Network network;
  double rate = 1.0;                   ///< 0: as fast as possible
  Duration start{};                    ///< from the bag's beginning
  std::optional<Duration> duration{};  ///< bag time; nothing: to the end
  std::optional<double> clock_hz{};    ///< publishes /clock
  bool is_paused = false;              ///< at the beginning
  std::vector<std::string> wait_for;   ///< played topics that must have a reader before the beginning
};

struct PlayerStatus {
  Duration position;            ///< from the bag's beginning
  Duration took{};              ///< real time from the first message to the last
  std::uint64_t published = 0;  ///< messages of the bag
  std::uint64_t latched = 0;    ///< messages from before the beginning
  std::uint64_t malformed = 0;  ///< messages that do not fit their type, left out
  std::uint64_t refused = 0;    ///< by DDS
  Duration latest{};            ///< the longest that a message was late
  bool is_waiting = true;       ///< for readers, before the beginning
  bool is_paused = false;
  double rate = 1.0;
};

/// Who watches and steers while it plays.
class PlayerControl {
 public:
  enum class Wish { none, pause, step, faster, slower, end };
  virtual ~PlayerControl() = default;
  /// Returns after `limit`, or earlier with a wish.
  virtual Wish wait(Duration limit, const PlayerStatus& status) = 0;
};

class TopicPlayer {
 public:
  /// Makes the writers. Throws as played_topics and dds::Participant do, and std::runtime_error when `start`
  /// is behind the bag's end. The bag must outlive this.
  TopicPlayer(const bag::Bag& recording, const PlayerOptions& options);

  /// Waits until readers that are there already have been found, plays, and waits until the reliable ones
  /// have it all.
  PlayerStatus run(PlayerControl& control);

  [[nodiscard]] std::size_t topics() const;  ///< that are played
  [[nodiscard]] std::vector<bag::BagFault> faults() const { return faults_; }

 private:
  struct Voice {
    std::unique_ptr<dds::Writer> writer;
    const TypeDescription* type = nullptr;  ///< nothing for a type that is not known
  };

  void open_writers();
  [[nodiscard]] const dds::Writer* writer_of(const std::string& name) const;
  [[nodiscard]] bool is_heard() const;
  bool wait_for_readers(PlayerControl& control);
  bool read();
  bool obey(PlayerControl::Wish wish);
  bool publish(std::size_t topic, bag::BytesView cdr);
  void publish_clock(Time position);
  void play(PlayerControl& control);
  void wait_for_delivery();
  const PlayerStatus& status();

  const bag::Bag& recording_;
  const PlayerOptions options_;
  const std::vector<std::optional<PlayedTopic>> played_;
  const Time start_;
  dds::Participant participant_;
  NodeAnnouncement announcement_;
  std::vector<Voice> voices_;  ///< by topic of the bag
  std::unique_ptr<dds::Writer> clock_;
  std::vector<const dds::Writer*> awaited_;
  std::unique_ptr<bag::BagMessages> messages_;
  std::optional<PlaySchedule> schedule_;
  Duration began_;           ///< steady clock
  bag::BagMessage message_;  ///< the next one
  std::vector<bag::BagFault> faults_;
  PlayerStatus status_;
};

}  // namespace bw::replay
