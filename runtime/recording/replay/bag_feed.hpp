// The recorded side of a replay: publishes what the bag holds of components that do not run, in virtual time
// and in the order of the recording, and tells the comparison what the running ones wrote.
//
// Within one instant a recorded message comes when all messages that the bag has before it have come, those
// of running components included. So every running component meets its inputs in the order of the recording.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/component.hpp"
#include "runtime/host/event_source.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/replay/output_comparison.hpp"
#include "runtime/recording/replay/reordered_messages.hpp"

namespace bw::replay {

struct FeedOptions {
  std::set<std::pair<std::string, std::string>>
      live;  ///< topic and node of what running components write: compared, not published
  std::set<std::string> ignored;               ///< neither
  std::uint64_t messages = ~std::uint64_t{0};  ///< only so many of the bag, from its beginning
  std::vector<Delay> delays = {};              ///< what comes in another order
  /// Sees every message of the run in its order, recorded ones and new ones, by the topic of the bag.
  std::function<void(std::size_t topic, Time log_time, Time publish_time, bag::BytesView cdr)> on_message =
      nullptr;
};

class BagFeed final : public EventSource {
 public:
  /// Bag and comparison must outlive this.
  BagFeed(const bag::Bag& recording, FeedOptions options, OutputComparison& comparison);

  /// The component through which it publishes; must come first in the graph's order. It must not outlive
  /// this.
  std::unique_ptr<Component> make_component();

  std::optional<Time> next() const override;
  void run(Time now) override;
  /// The running component `node` wrote a message.
  void on_live(const std::string& topic, const std::string& node, Time now, bag::BytesView cdr);
  /// The rest of the bag, when the run is over.
  void finish();

  [[nodiscard]] std::uint64_t published() const { return published_; }
  /// Messages that do not fit their type; they were not published.
  [[nodiscard]] std::uint64_t malformed() const { return malformed_; }
  /// Topics whose type has our name and is not ours, with the reason; nothing of them was published.
  [[nodiscard]] const std::vector<std::string>& refused() const { return refused_; }
  [[nodiscard]] std::optional<bag::BagFault> damage() const { return damage_; }

 private:
  class Player;
  enum class Role { played, refused, live, ignored };

  void read();
  void advance(Time now);
  void publish();
  std::string name_of(const std::string& topic, const std::string& node) const;
  void tell_live(const std::string& topic, const std::string& node, Time now, bag::BytesView cdr) const;

  const bag::Bag& recording_;
  FeedOptions options_;
  OutputComparison& comparison_;
  std::unique_ptr<bag::BagMessages> messages_;
  std::map<std::string, int> writers_;  ///< by topic: how many the bag knows
  std::vector<Role> roles_;             ///< by topic of the bag
  std::vector<OutputPort*> ports_;      ///< by topic of the bag; null: not played
  std::vector<const TypeDescription*> types_;
  std::vector<std::string> dds_names_;  ///< of the types, by topic

  std::optional<bag::BagMessage> pending_;  ///< the next message of the bag
  bool pending_is_told_ = false;            ///< a live one, and the comparison knows it
  std::uint64_t read_ = 0;
  std::map<std::string, std::int64_t> ahead_;  ///< live messages that came less those the bag had
  std::optional<Time> last_run_;
  std::uint64_t published_ = 0;
  std::uint64_t malformed_ = 0;
  std::vector<std::string> refused_;
  std::optional<bag::BagFault> damage_;
  bool is_active_ = false;
};

}  // namespace bw::replay
