#include "runtime/cli/action_session.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include <action_msgs/srv/cancel_goal.hpp>
#include <fmt/format.h>

#include "runtime/goal_id.hpp"
#include "runtime/ros/dds_names.hpp"

namespace bw::cli {
namespace {

using action_msgs::srv::CancelGoal;

constexpr std::size_t kEncapsulation = 4;

GoalId random_id() {
  std::random_device random;
  return new_goal_id([&random] { return static_cast<std::uint8_t>(random()); });
}

/// Requests and feedback begin with the id of their goal.
bool is_about(const std::vector<std::uint8_t>& cdr, const GoalId& id) {
  return cdr.size() >= kEncapsulation + id.size() &&
         std::equal(id.begin(), id.end(), cdr.begin() + kEncapsulation);
}

std::int64_t sent(std::optional<std::int64_t> request) {
  if (!request) throw std::runtime_error("DDS refused a request");
  return *request;
}

}  // namespace

ActionSession::ActionSession(dds::Participant& participant, const std::string& action,
                             const ActionLayout& layout)
    : id_(random_id()),
      send_goal_(participant, action + "/_action/send_goal", layout.send_goal(),
                 [this] { notifier_.ring(); }),
      cancel_goal_(participant, action + "/_action/cancel_goal", service_type<CancelGoal>(),
                   [this] { notifier_.ring(); }),
      get_result_(participant, action + "/_action/get_result", layout.get_result(),
                  [this] { notifier_.ring(); }),
      feedback_(
          participant.create_reader({.topic = dds_topic(action + "/_action/feedback"),
                                     .type = std::string(layout.feedback->dds_name),
                                     .qos = Qos::standard(),
                                     .user_data = user_data_of(std::string(layout.feedback->type_hash))},
                                    [this] { notifier_.ring(); })) {}

std::string ActionSession::id_text() const {
  std::string text;
  for (const std::uint8_t byte : id_) text += fmt::format("{:02x}", byte);
  return text;
}

bool ActionSession::is_ready() const {
  return send_goal_.is_ready() && cancel_goal_.is_ready() && get_result_.is_ready() &&
         feedback_->matched_writers() > 0;
}

void ActionSession::send(Bytes request) {
  std::ranges::copy(id_, request.begin() + kEncapsulation);
  sent_ = sent(send_goal_.send(request));
}

std::optional<bool> ActionSession::take_acknowledgement() {
  const auto reply = send_goal_.take(sent_.value());
  if (!reply) return std::nullopt;
  const bool is_accepted = reply->size() > kEncapsulation && (*reply)[kEncapsulation] != 0;
  if (is_accepted) {
    Bytes request = {0, 1, 0, 0};
    request.insert(request.end(), id_.begin(), id_.end());
    asked_ = sent(get_result_.send(request));
  }
  return is_accepted;
}

void ActionSession::cancel() {
  CancelGoal::Request request;
  request.goal_info().goal_id().uuid(id_);
  Bytes cdr;
  serialize(request, cdr);
  canceled_ = sent(cancel_goal_.send(cdr));
}

std::optional<std::int8_t> ActionSession::take_cancel_code() {
  if (!canceled_) return std::nullopt;
  const auto reply = cancel_goal_.take(*canceled_);
  CancelGoal::Response response;
  if (!reply || !deserialize(*reply, response)) return std::nullopt;
  return static_cast<std::int8_t>(response.return_code());
}

std::optional<ActionSession::Bytes> ActionSession::take_feedback() {
  dds::Sample sample;
  while (feedback_->take(sample)) {
    if (is_about(sample.cdr, id_)) return std::move(sample.cdr);
  }
  return std::nullopt;
}

std::optional<ActionSession::Bytes> ActionSession::take_result() { return get_result_.take(asked_.value()); }

}  // namespace bw::cli
