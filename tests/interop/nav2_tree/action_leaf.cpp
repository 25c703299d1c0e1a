#include "tests/interop/nav2_tree/action_leaf.hpp"

#include <functional>

#include "tests/interop/eventually.hpp"

namespace nav2 {
namespace {

constexpr int kLeafSucceeded = 4, kLeafCanceled = 5;

}  // namespace

ActionLeaf::ActionLeaf(plain::Node& node, Journal& journal, PostedTask errand)
    : journal_(journal),
      errand_(std::move(errand)),
      client_(node, "/" + errand_.action, plain::action_type(errand_.type)),
      count_(static_cast<std::uint32_t>(std::hash<std::string>{}(errand_.action)) & 0xffff0000U) {}

Status ActionLeaf::on_tick() {
  if (status() != Status::running) {
    running_.reset();
    send(errand_.goal());
  }
  if (const Status status = acknowledged(); status != Status::success) return status;
  if (!running_->end) {
    if (const auto goal = errand_.new_goal()) {
      journal_.preemptions.push_back(journal_.now());
      send(*goal);
      if (const Status status = acknowledged(); status != Status::success) return status;
    }
  }
  poll();
  return ended();
}

void ActionLeaf::send(const Bytes& goal) {
  const plain::GoalId id = plain::goal_id(++count_);
  const auto at = Clock::now();
  pending_ = Sent{.id = id, .request = client_.ask_goal(id, goal), .at = at};
}

/// Success when no acknowledgement is awaited any more; running while there is time left. As in the original,
/// an answer that comes between two ticks is looked at in the next one, and no more once the 20 ms are over:
/// in effect they are 15.
Status ActionLeaf::acknowledged() {
  if (!pending_) return Status::success;
  const bool is_late = Clock::now() - pending_->at >= kServerTimeout;
  if (!is_late) wait_until(Clock::now() + kWaitInTick, [this] { return pending_->answer.has_value(); });
  if (is_late || (!pending_->answer && Clock::now() - pending_->at >= kServerTimeout)) {
    if (!pending_->answer)
      journal_.exchanges.push_back({.what = errand_.action, .at = journal_.since(pending_->at)});
    journal_.troubles.push_back(errand_.action + ": the goal was not acknowledged within 20 ms");
    pending_.reset();
    return Status::failure;
  }
  if (!pending_->answer) return Status::running;
  const Sent sent = *pending_;
  pending_.reset();
  if (!sent.answer->is_accepted) {
    journal_.troubles.push_back(errand_.action + ": the goal was rejected");
    return Status::failure;
  }
  if (running_) replaced_.push_back(*running_);
  running_ = sent;
  return Status::success;
}

void ActionLeaf::poll() {
  poll_acknowledgement();
  const auto take = [this](Sent& goal) {
    if (goal.end) return;
    if (const auto result = client_.take_result(goal.result_request)) goal.end = errand_.read(result->bytes);
  };
  if (running_) take(*running_);
  std::erase_if(replaced_, [&](Sent& goal) {
    take(goal);
    if (goal.end) note_end(goal, true);
    return goal.end.has_value();
  });
}

void ActionLeaf::poll_acknowledgement() {
  if (!pending_ || pending_->answer) return;
  pending_->answer = client_.take_goal(pending_->request);
  if (!pending_->answer) return;
  journal_.exchanges.push_back({.what = errand_.action,
                                .at = journal_.since(pending_->at),
                                .took = std::chrono::duration<double>(Clock::now() - pending_->at).count(),
                                .accepted = pending_->answer->is_accepted});
  // As rclcpp's client, which asks for the result as soon as the goal is accepted.
  if (pending_->answer->is_accepted) pending_->result_request = client_.ask_result(pending_->id);
}

bool ActionLeaf::wait_until(Clock::time_point end, const std::function<bool()>& seen) {
  return bw::test::poll_until(end, kLook, [&] {
    poll();
    return seen();
  });
}

Status ActionLeaf::ended() {
  if (!running_->end) return Status::running;
  note_end(*running_, false);
  const Outcome end = *running_->end;
  errand_.on_end(end);
  return end.status == kLeafSucceeded || end.status == kLeafCanceled ? Status::success : Status::failure;
}

void ActionLeaf::note_end(const Sent& goal, bool was_replaced) {
  journal_.ends.push_back({.action = errand_.action,
                           .at = journal_.now(),
                           .status = goal.end->status,
                           .code = goal.end->error.code,
                           .text = goal.end->error.text,
                           .was_replaced = was_replaced});
  if (goal.end->status == kLeafSucceeded || goal.end->error.code == 0 || was_replaced) return;
  journal_.troubles.push_back(errand_.action + ": " + std::to_string(goal.end->error.code) + " " +
                              goal.end->error.text);
}

/// Cancels what runs. A goal that was not acknowledged yet is left alone, as by the original.
void ActionLeaf::on_halt() {
  pending_.reset();
  if (!running_) return;
  poll();
  if (running_->end) return;
  const auto at = Clock::now();
  const std::int64_t asked = client_.ask_cancel({.id = running_->id, .stamp = {}});
  std::optional<plain::CancelReply> reply;
  wait_until(at + kServerTimeout, [&] {
    if (!reply) reply = client_.take_cancel(asked);
    return reply.has_value();
  });
  Exchange exchange{.what = errand_.action + " cancel", .at = journal_.since(at)};
  if (reply) {
    exchange.took = std::chrono::duration<double>(Clock::now() - at).count();
    exchange.accepted = reply->code == plain::CancelCode::none;
  }
  journal_.exchanges.push_back(exchange);
  if (wait_until(Clock::now() + kCancelTimeout, [this] { return running_->end.has_value(); })) {
    note_end(*running_, false);
    errand_.on_end(*running_->end);
  } else {
    journal_.troubles.push_back(errand_.action + ": no result within 50 ms of its cancelation");
    replaced_.push_back(*running_);
  }
  running_.reset();
}

}  // namespace nav2
