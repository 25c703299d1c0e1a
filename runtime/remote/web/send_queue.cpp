#include "runtime/remote/web/send_queue.hpp"

#include <utility>

namespace bw::web {

SendQueue::Amount& SendQueue::amount_of(Keep::Rule rule) {
  switch (rule) {
    case Keep::Rule::newest:
      return data_;
    case Keep::Rule::latched:
      return latched_;
    case Keep::Rule::always:
      break;
  }
  return control_;
}

bool SendQueue::push(Frame frame, Keep keep) {
  const std::size_t size = frame.size();
  if (keep.rule == Keep::Rule::always && control_.frames > 0 &&
      (control_.frames + 1 > limits_.control_frames || control_.bytes + size > limits_.control_bytes)) {
    return false;
  }
  Amount& amount = amount_of(keep.rule);
  amount.frames += 1;
  amount.bytes += size;
  const Position position = queue_.insert(queue_.end(), Entry{std::move(frame), keep, std::nullopt});
  if (keep.rule == Keep::Rule::always) return true;

  if (const auto [known, is_new] = newest_.try_emplace(keep.stream, position); !is_new) {
    supersede(std::exchange(known->second, position));
  }
  while (is_over() && !superseded_.empty()) {
    take_out(superseded_.front());
    ++left_out_;
  }
  return true;
}

void SendQueue::supersede(Position older) {
  if (older->keep.rule == Keep::Rule::latched) {
    take_out(older);
  } else {
    older->superseded = superseded_.insert(superseded_.end(), older);
  }
}

bool SendQueue::is_over() const {
  return data_.frames > limits_.data_frames || data_.bytes > limits_.data_bytes;
}

void SendQueue::take_out(Position position) {
  Amount& amount = amount_of(position->keep.rule);
  amount.frames -= 1;
  amount.bytes -= position->frame.size();
  if (position->superseded) superseded_.erase(*position->superseded);
  if (position->keep.rule != Keep::Rule::always) {
    const auto newest = newest_.find(position->keep.stream);
    if (newest != newest_.end() && newest->second == position) newest_.erase(newest);
  }
  queue_.erase(position);
}

std::optional<Frame> SendQueue::pop() {
  if (queue_.empty()) return std::nullopt;
  Frame frame = queue_.front().frame;
  take_out(queue_.begin());
  return frame;
}

void SendQueue::clear() {
  queue_.clear();
  superseded_.clear();
  newest_.clear();
  data_ = control_ = latched_ = {};
}

}  // namespace bw::web
