#include "tests/interop/nav2_tree/default_tree.hpp"

#include <algorithm>
#include <initializer_list>

#include "tests/interop/eventually.hpp"

namespace nav2 {
namespace {

constexpr int kSucceeded = 4, kAborted = 6;
constexpr std::chrono::seconds kReplanning{1};
constexpr int kTimeAllowance = 10;  // [s] default of spin and backup

bool is_one_of(int code, std::initializer_list<int> codes) {
  return std::ranges::find(codes, code) != codes.end();
}

template <class... Nodes>
NodePtr sequence(Nodes... nodes) {
  return std::make_unique<Sequence>(children(std::move(nodes)...));
}

template <class... Nodes>
NodePtr recovery(int retries, Nodes... nodes) {
  return std::make_unique<RecoveryNode>(retries, children(std::move(nodes)...));
}

}  // namespace

DefaultTree::DefaultTree(plain::Node& node, Journal& journal, Blackboard& board)
    : node_(node),
      journal_(journal),
      board_(board),
      root_(recovery(6, navigate_with_replanning(), recover())) {}

NodePtr DefaultTree::navigate_with_replanning() {
  auto plan = std::make_unique<RateController>(
      kReplanning, recovery(1, compute_path(), sequence(planner_recovery_helps(), clear("global_costmap"))));
  auto follow = recovery(1, follow_path(), sequence(controller_recovery_helps(), clear("local_costmap")));
  return std::make_unique<PipelineSequence>(children(NodePtr(std::move(plan)), std::move(follow)));
}

NodePtr DefaultTree::recover() {
  auto helps = std::make_unique<Fallback>(children(controller_recovery_helps(), planner_recovery_helps()));
  auto in_turn = std::make_unique<RoundRobin>(
      children(sequence(clear("local_costmap"), clear("global_costmap")),
               behavior("spin", "nav2_msgs/action/Spin", spin_goal(1.57F, kTimeAllowance)),
               behavior("wait", "nav2_msgs/action/Wait", wait_goal(5)),
               behavior("backup", "nav2_msgs/action/BackUp", back_up_goal(0.30, 0.15F, kTimeAllowance))));
  return sequence(NodePtr(std::move(helps)), NodePtr(std::move(in_turn)));
}

NodePtr DefaultTree::action(PostedTask errand) {
  auto leaf = std::make_unique<ActionLeaf>(node_, journal_, std::move(errand));
  actions_.push_back(leaf.get());
  return leaf;
}

NodePtr DefaultTree::compute_path() {
  return action({.action = "compute_path_to_pose",
                 .type = "nav2_msgs/action/ComputePathToPose",
                 .goal = [this] { return compute_path_goal(board_.goal, board_.selected_planner); },
                 .read = read_compute_path_result,
                 .on_end =
                     [this](const Outcome& end) {
                       board_.path = end.status == kSucceeded ? end.path : Path{};
                       board_.compute_path_error_code = end.status == kAborted ? end.error.code : 0;
                     }});
}

NodePtr DefaultTree::follow_path() {
  const auto sent = std::make_shared<Path>();
  const auto goal = [this, sent] {
    *sent = board_.path;
    return follow_path_goal(*sent, board_.selected_controller);
  };
  return action({.action = "follow_path",
                 .type = "nav2_msgs/action/FollowPath",
                 .goal = goal,
                 .new_goal = [this, sent, goal]() -> std::optional<Bytes> {
                   if (board_.path == *sent || board_.path == Path{}) return std::nullopt;
                   return goal();
                 },
                 .read = read_follow_path_result,
                 .on_end =
                     [this](const Outcome& end) {
                       board_.follow_path_error_code = end.status == kAborted ? end.error.code : 0;
                     }});
}

NodePtr DefaultTree::behavior(const std::string& name, const std::string& type, const Bytes& goal) {
  return action({.action = name,
                 .type = type,
                 .goal =
                     [this, goal] {
                       ++board_.number_recoveries;
                       return goal;
                     },
                 .read = read_behavior_result});
}

NodePtr DefaultTree::clear(const std::string& costmap) {
  auto leaf = std::make_unique<ClearCostmap>(node_, journal_, costmap + "/clear_entirely_" + costmap,
                                             [this] { ++board_.number_recoveries; });
  services_.push_back(leaf.get());
  return leaf;
}

NodePtr DefaultTree::planner_recovery_helps() {
  return std::make_unique<Check>([this] {
    return is_one_of(board_.compute_path_error_code, {200, 207, 208, 300, 307, 308});
  });
}

NodePtr DefaultTree::controller_recovery_helps() {
  return std::make_unique<Check>([this] {
    return is_one_of(board_.follow_path_error_code, {100, 104, 105, 106});
  });
}

std::optional<std::string> DefaultTree::missing_server() {
  const auto is_there = [](auto& client) {
    constexpr std::chrono::milliseconds kPause{1};
    return bw::test::poll_until(Clock::now() + std::chrono::seconds(1), kPause,
                                [&client] { return client.is_ready(); });
  };
  for (ActionLeaf* leaf : actions_) {
    if (!is_there(leaf->client())) return "action " + leaf->action();
  }
  for (ClearCostmap* leaf : services_) {
    if (!is_there(leaf->client())) return "service " + leaf->service();
  }
  return std::nullopt;
}

void DefaultTree::poll() {
  for (ActionLeaf* leaf : actions_) leaf->poll();
}

}  // namespace nav2
