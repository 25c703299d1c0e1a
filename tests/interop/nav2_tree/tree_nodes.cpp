#include "tests/interop/nav2_tree/tree_nodes.hpp"

namespace nav2 {

Status Sequence::on_tick() {
  for (; at_ < children_.size(); ++at_) {
    const Status status = children_[at_]->tick();
    if (status == Status::running) return status;
    if (status == Status::failure) return done(status);
  }
  return done(Status::success);
}

Status Fallback::on_tick() {
  for (; at_ < children_.size(); ++at_) {
    const Status status = children_[at_]->tick();
    if (status == Status::running) return status;
    if (status == Status::success) return done(status);
  }
  return done(Status::failure);
}

Status PipelineSequence::on_tick() {
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const Status status = children_[i]->tick();
    if (status == Status::failure) return done(status);
    if (status == Status::running && i >= at_) {
      at_ = i;
      return status;
    }
  }
  return done(Status::success);
}

Status RecoveryNode::on_tick() {
  for (;;) {
    const Status status = children_[at_]->tick();
    if (status == Status::running) return status;
    children_[at_]->halt();
    if (at_ == 0) {
      if (status == Status::success || retried_ >= retries_) return done(status);
      at_ = 1;
    } else {
      if (status == Status::failure) return done(status);
      ++retried_;
      at_ = 0;
    }
  }
}

Status RoundRobin::on_tick() {
  while (failed_ < children_.size()) {
    const Status status = children_[at_]->tick();
    if (status == Status::running) return status;
    at_ = (at_ + 1) % children_.size();
    if (status == Status::success) {
      failed_ = 0;
      halt_children();
      return status;
    }
    ++failed_;
  }
  return done(Status::failure);
}

Status RateController::on_tick() {
  const bool is_first = status() == Status::idle;
  if (is_first) start_ = Clock::now();
  if (!is_first && child_->status() != Status::running && Clock::now() - start_ < period_)
    return Status::running;
  const Status status = child_->tick();
  if (status == Status::success) start_ = Clock::now();
  return status;
}

}  // namespace nav2
