#include "runtime/recording/replay/reordered_messages.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace bw::replay {
namespace {

class ReorderedMessages final : public bag::BagMessages {
 public:
  ReorderedMessages(std::unique_ptr<bag::BagMessages> messages, std::vector<Delay> delays)
      : messages_(std::move(messages)), delays_(std::move(delays)) {}

  bag::Step next(bag::BagMessage& message) override {
    if (!due_.empty()) {
      current_ = std::move(due_.front());
      due_.pop_front();
      message = current_.message;
      message.data = current_.data;
      release(current_.number, message.log_time);
      return bag::Step::message;
    }
    for (;;) {
      const bag::Step step = messages_->next(message);
      if (step != bag::Step::message) return step;
      const std::uint64_t number = read_++;
      if (std::ranges::find(delays_, number, &Delay::message) == delays_.end()) {
        release(number, message.log_time);
        return step;
      }
      held_.push_back({number, message, {message.data.begin(), message.data.end()}});
    }
  }
  [[nodiscard]] bag::BagFault fault() const override { return messages_->fault(); }

 private:
  struct Held {
    std::uint64_t number = 0;
    bag::BagMessage message;
    bag::Bytes data;
  };

  /// Message `number` has come at `time`: what is to come behind it is next.
  void release(std::uint64_t number, Time time) {
    for (const Delay& delay : delays_) {
      if (delay.behind != number) continue;
      const auto found = std::ranges::find(held_, delay.message, &Held::number);
      if (found == held_.end()) continue;
      found->message.log_time = time;
      due_.push_back(std::move(*found));
      held_.erase(found);
    }
  }

  std::unique_ptr<bag::BagMessages> messages_;
  std::vector<Delay> delays_;
  std::uint64_t read_ = 0;
  std::vector<Held> held_;
  std::deque<Held> due_;
  Held current_;  ///< owns what the last message's data is a view of
};

}  // namespace

std::unique_ptr<bag::BagMessages> reordered(std::unique_ptr<bag::BagMessages> messages,
                                            std::vector<Delay> delays) {
  if (delays.empty()) return messages;
  return std::make_unique<ReorderedMessages>(std::move(messages), std::move(delays));
}

}  // namespace bw::replay
