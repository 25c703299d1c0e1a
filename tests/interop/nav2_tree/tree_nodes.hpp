// The nodes of a behaviour tree that Nav2's default trees are made of, with the semantics of BehaviorTree.CPP
// 4 and of nav2_behavior_tree: who keeps its place between ticks, who ticks again from the first child, what
// halting means.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

namespace nav2 {

using Clock = std::chrono::steady_clock;

enum class Status { idle, running, success, failure };

class TreeNode {
 public:
  virtual ~TreeNode() = default;
  Status tick() { return status_ = on_tick(); }
  /// Idle again; what runs is interrupted.
  void halt() {
    if (status_ == Status::running) on_halt();
    status_ = Status::idle;
  }
  Status status() const { return status_; }

 protected:
  virtual Status on_tick() = 0;
  virtual void on_halt() {}

 private:
  Status status_ = Status::idle;
};

using NodePtr = std::unique_ptr<TreeNode>;

template <class... Nodes>
std::vector<NodePtr> children(Nodes... nodes) {
  std::vector<NodePtr> all;
  (all.push_back(std::move(nodes)), ...);
  return all;
}

class ControlNode : public TreeNode {
 public:
  explicit ControlNode(std::vector<NodePtr> all) : children_(std::move(all)) {}

 protected:
  void halt_children() {
    for (const NodePtr& child : children_) child->halt();
  }
  void on_halt() override {
    at_ = 0;
    halt_children();
  }
  Status done(Status status) {
    on_halt();
    return status;
  }
  std::vector<NodePtr> children_;
  std::size_t at_ = 0;
};

/// One after the other while they succeed; keeps its place.
class Sequence final : public ControlNode {
 public:
  using ControlNode::ControlNode;

 private:
  Status on_tick() override;
};

/// The first that succeeds; keeps its place.
class Fallback final : public ControlNode {
 public:
  using ControlNode::ControlNode;

 private:
  Status on_tick() override;
};

/// A sequence in which those before the one that runs are ticked too, so that they may bring something new.
class PipelineSequence final : public ControlNode {
 public:
  using ControlNode::ControlNode;

 private:
  Status on_tick() override;
};

/// The first child again whenever the second, the recovery, has succeeded, `retries` times.
class RecoveryNode final : public ControlNode {
 public:
  RecoveryNode(int retries, std::vector<NodePtr> all) : ControlNode(std::move(all)), retries_(retries) {}

 private:
  Status on_tick() override;
  void on_halt() override {
    retried_ = 0;
    ControlNode::on_halt();
  }
  int retries_;
  int retried_ = 0;
};

/// Another child at each success, in turn, from one activation to the next.
class RoundRobin final : public ControlNode {
 public:
  using ControlNode::ControlNode;

 private:
  Status on_tick() override;
  void on_halt() override {
    failed_ = 0;
    ControlNode::on_halt();
  }
  std::size_t failed_ = 0;
};

/// Ticks its child at once, then each time `period` has passed since the last success; running in between.
class RateController final : public TreeNode {
 public:
  RateController(std::chrono::milliseconds period, NodePtr child)
      : period_(period), child_(std::move(child)) {}

 private:
  Status on_tick() override;
  void on_halt() override { child_->halt(); }
  std::chrono::milliseconds period_;
  NodePtr child_;
  Clock::time_point start_;
};

/// A condition.
class Check final : public TreeNode {
 public:
  explicit Check(std::function<bool()> holds) : holds_(std::move(holds)) {}

 private:
  Status on_tick() override { return holds_() ? Status::success : Status::failure; }
  std::function<bool()> holds_;
};

}  // namespace nav2
