#include "components/lab/battery/soak_watch.hpp"

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/model/robot.hpp"

namespace bw {

void SoakWatch::configure(Setup& setup) {
  robot_ = setup.shared<Robot>("robot").outline();
  setup.input<bandwagon_msgs::msg::GroundTruth>(
      "sim/ground_truth", Qos::standard(), [this](const auto& truth, const Tick&) { hear(to_truth(truth)); },
      Need::optional);
  setup.input<bandwagon_msgs::msg::NavigationStatus>(
      "navigation_status", Qos::standard(),
      [this](const auto& message, const Tick&) {
        const GoalNews news = to_goal_news(message);
        if (!news.is_over || news.goal_id == decided_) return;
        decided_ = news.goal_id;
        if (news.is_claimed) {
          ++count_->reached;
        } else {
          ++count_->missed[news.reason];
        }
      },
      Need::optional);
  setup.every(Duration::seconds(60), "minute", [this](const Tick& tick) {
    if (!began_) return;
    const double now = (tick.now - *began_).to_seconds();
    turn_page(now);
    on_minute_(now);
  });
}

void SoakWatch::hear(const TruthSample& sample) {
  if (!began_) began_ = sample.time;
  if (last_.time < sample.time) count_->path += (sample.X_MB.position() - last_.X_MB.position()).norm();
  count_->touched = sample.contacts;
  last_ = sample;
  diary_.add((sample.time - *began_).to_seconds(), sample, robot_);
}

void SoakWatch::turn_page(double now) {
  constexpr double kMoment = 1.0;  // [s]
  for (const ContactRecord& contact : diary_.contacts()) {
    if (now - contact.end < kMoment) return;
  }
  for (const ContactRecord& contact : diary_.contacts()) {
    ++count_->contacts[contact.closing.who];
    if (contact.at_speed) ++count_->at_speed[contact.closing.who];
  }
  diary_ = {};
}

}  // namespace bw
