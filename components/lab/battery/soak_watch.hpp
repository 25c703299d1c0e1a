// Hears how a robot fares that drives to and fro for hours: its goals, and every contact.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "components/evaluation/contact_diary.hpp"
#include "runtime/component.hpp"

namespace bw {

struct SoakCount {
  int reached = 0;                           ///< goals, as the navigator reports
  std::map<std::string, int> missed;         ///< by the reason that it gives
  std::map<WhoHit, int> contacts, at_speed;  ///< with people; of those, the robot moved
  std::uint32_t touched = 0;                 ///< with anything, as the world counts
  double path = 0.0;                         ///< truly driven [m]
  [[nodiscard]] int caused() const {         ///< by the robot, at speed
    const auto found = at_speed.find(WhoHit::robot_closing);
    return found == at_speed.end() ? 0 : found->second;
  }
};

/// A component beside those of the graph, or in a process of its own.
class SoakWatch final : public Component {
 public:
  /// `on_minute` is called each minute, with the time since the first truth [s].
  SoakWatch(std::shared_ptr<SoakCount> count, std::function<void(double)> on_minute)
      : count_(std::move(count)), on_minute_(std::move(on_minute)) {}

  void configure(Setup& setup) override;

 private:
  void hear(const TruthSample& sample);
  /// Counts what the diary has and begins another, where nobody was touched a moment ago.
  void turn_page(double now);

  std::shared_ptr<SoakCount> count_;
  std::function<void(double)> on_minute_;
  Footprint robot_;
  ContactDiary diary_;
  std::optional<Time> began_;
  TruthSample last_;
  std::uint64_t decided_ = 0;  ///< the last goal
};

}  // namespace bw
