#include "tests/interop/plain/action_client.hpp"

#include "tests/interop/eventually.hpp"

namespace plain {
namespace {

bool is_connected(const dds::DataReader& reader) {
  dds::SubscriptionMatchedStatus writers;
  reader.get_subscription_matched_status(writers);
  return writers.current_count > 0;
}

/// So that no list is missed between two looks; what a writer keeps for late readers is its own affair.
EndOptions deep(EndOptions end) {
  end.depth = 1000;
  return end;
}

Bytes goal_info(const GoalInfo& which) {
  CdrOut cdr;
  write(cdr, which);
  return cdr.bytes();
}

Acknowledgement read_acknowledgement(const Bytes& bytes) {
  CdrIn cdr(bytes);
  Acknowledgement answer;
  answer.is_accepted = cdr.number<std::uint8_t>() != 0;
  answer.stamp.sec = cdr.number<std::int32_t>();
  answer.stamp.nanosec = cdr.number<std::uint32_t>();
  return answer;
}

CancelReply read_cancel_reply(const Bytes& bytes) {
  CdrIn cdr(bytes);
  CancelReply answer;
  answer.code = static_cast<CancelCode>(cdr.number<std::int8_t>());
  answer.canceling.resize(cdr.number<std::uint32_t>());
  for (GoalInfo& info : answer.canceling) info = read_goal_info(cdr);
  return answer;
}

Result read_result(const Bytes& bytes) {
  CdrIn cdr(bytes);
  const auto status = static_cast<GoalStatus>(cdr.number<std::int8_t>());
  return {.status = status, .fields = cdr, .bytes = bytes};
}

template <class Value>
std::optional<Value> read(const std::optional<Bytes>& bytes, Value (*reader)(const Bytes&)) {
  return bytes ? std::optional(reader(*bytes)) : std::nullopt;
}

}  // namespace

ActionClient::ActionClient(Node& node, const std::string& action, const ActionType& type)
    : node_(node),
      action_(action),
      goals_(node, action + "/_action/send_goal", type.send_goal, Client::Identity::reply_reader, 1000),
      cancels_(node, action + "/_action/cancel_goal", type.cancel_goal, Client::Identity::reply_reader, 1000),
      results_(node, action + "/_action/get_result", type.get_result, Client::Identity::reply_reader, 1000),
      feedback_reader_(node.create_reader(deep(feedback_end(action, type)))),
      status_reader_(node.create_reader(deep(status_end(action, type)))) {
  node_.announce();
}

ActionClient::~ActionClient() {
  node_.remove(feedback_reader_);
  node_.remove(status_reader_);
}

bool ActionClient::is_ready() const {
  return goals_.is_ready() && cancels_.is_ready() && results_.is_ready() && is_connected(*feedback_reader_) &&
         is_connected(*status_reader_);
}

bool ActionClient::wait_until_ready(std::chrono::milliseconds limit) const {
  constexpr std::chrono::milliseconds kPause{2};
  return bw::test::poll_until(std::chrono::steady_clock::now() + limit, kPause,
                              [this] { return is_ready(); });
}

std::optional<Acknowledgement> ActionClient::send(const GoalId& id, const Bytes& goal) {
  return read(goals_.call(with_goal_id(id, goal), kLimit), read_acknowledgement);
}

std::optional<CancelReply> ActionClient::cancel(const GoalInfo& which) {
  return read(cancels_.call(goal_info(which), kLimit), read_cancel_reply);
}

std::optional<Result> ActionClient::result(const GoalId& id) {
  return read(results_.call(CdrOut().octets(id).bytes(), kLimit), read_result);
}

std::optional<Acknowledgement> ActionClient::take_goal(std::int64_t asked) {
  return read(goals_.take(asked), read_acknowledgement);
}

std::int64_t ActionClient::ask_cancel(const GoalInfo& which) { return cancels_.send(goal_info(which)); }

std::optional<CancelReply> ActionClient::take_cancel(std::int64_t asked) {
  return read(cancels_.take(asked), read_cancel_reply);
}

std::int64_t ActionClient::ask_result(const GoalId& id) { return results_.send(CdrOut().octets(id).bytes()); }

std::optional<Result> ActionClient::take_result(std::int64_t asked) {
  return read(results_.take(asked), read_result);
}

const std::vector<std::vector<GoalState>>& ActionClient::status_lists() {
  Bytes bytes;
  dds::SampleInfo info;
  while (bw::fast_dds::is_ok(status_reader_->take_next_sample(&bytes, &info))) {
    if (info.valid_data) status_lists_.push_back(read_status_list(bytes));
  }
  return status_lists_;
}

const std::vector<Feedback>& ActionClient::feedback() {
  Bytes bytes;
  dds::SampleInfo info;
  while (bw::fast_dds::is_ok(feedback_reader_->take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    CdrIn cdr(bytes);
    GoalId id;
    std::copy_n(cdr.take(id.size()), id.size(), id.begin());
    feedback_.push_back({.id = id, .fields = cdr, .bytes = bytes});
  }
  return feedback_;
}

std::vector<GoalStatus> ActionClient::history(const GoalId& id) {
  std::vector<GoalStatus> all;
  for (const auto& list : status_lists()) {
    for (const GoalState& goal : list) {
      if (goal.info.id == id && (all.empty() || all.back() != goal.status)) all.push_back(goal.status);
    }
  }
  return all;
}

}  // namespace plain
