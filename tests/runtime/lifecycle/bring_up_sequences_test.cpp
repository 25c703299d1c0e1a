// Every command of a manager to three nodes, from all states that they may be in, with every way in which
// each step may end. The plan ends, asks only for transitions that there are, and leaves no half graph active
// when the way up fails.
#include <optional>
#include <string>
#include <vector>

#include "runtime/lifecycle/bring_up.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw::lifecycle {
namespace {

constexpr std::size_t kNodes = 3;
constexpr int kMaxSteps = 3 * static_cast<int>(kNodes) * 2;

struct ManagedWorld {
  std::vector<State> nodes = std::vector<State>(kNodes, State::unconfigured);
  std::optional<BringUp> bring_up;
  Command command = Command::startup;
  int steps = 0;
  bool is_brought_down = true;  ///< no step down has failed since the last command
  std::string violation;

  void begin(Command asked) {
    if (bring_up) return;  // refused while another one is under way
    command = asked;
    bring_up.emplace(asked, nodes);
    steps = 0;
    is_brought_down = true;
    judge();
  }
  /// The step that is due, and how its work ends.
  void step(Outcome outcome) {
    if (!bring_up) return;
    const auto step = bring_up->next();
    if (!step) return;
    if (++steps > kMaxSteps) violation = "it does not end";
    const Transition* transition = requested_transition(nodes[step->node], step->id, step->transition);
    if (transition == nullptr) {
      violation = "a transition that the node does not have";
      return;
    }
    State state = finishing_transition(transition->goal, outcome).goal;
    if (state == State::errorprocessing) state = finishing_transition(state, Outcome::success).goal;
    if (step->transition == "deactivate" && outcome == Outcome::failure) is_brought_down = false;
    nodes[step->node] = state;
    bring_up->finished(state);
    judge();
  }
  /// A node fails by itself, or somebody else moves it: the plan does not know.
  void move(std::size_t node, State state) {
    if (!bring_up) nodes[node] = state;
  }

  void judge() {
    const auto next = bring_up->next();
    if (next) {
      const auto again = bring_up->next();
      if (!again || again->node != next->node || again->transition != next->transition)
        violation = "the step changes while nobody takes it";
      return;
    }
    const bool failed = bring_up->failure().has_value();
    std::size_t active = 0;
    for (const State state : nodes) active += state == State::active ? 1 : 0;
    if (bring_up->nodes() != nodes) violation = "it takes nodes for what they are not";
    const bool is_up = command == Command::startup || command == Command::resume;
    if (is_up && !failed && active != kNodes) violation = "it says that all are up";
    if (is_up && failed && active > 0 && is_brought_down) violation = "half a graph is active";
    if (!is_up && command != Command::configure && active > 0 && !failed)
      violation = "it says that all are down";
    bring_up.reset();
  }
};

TEST(BringUp, EndsAndLeavesNoHalfGraphActiveInEverySequence) {
  using World = ManagedWorld;
  test::Sequences<World> sequences{
      .make = [] { return World{}; },
      .events = {{"it succeeds", [](World& w) { w.step(Outcome::success); }},
                 {"it fails", [](World& w) { w.step(Outcome::failure); }},
                 {"it is an error", [](World& w) { w.step(Outcome::error); }},
                 {"the second dies", [](World& w) { w.move(1, State::unconfigured); }},
                 {"the third is shut down", [](World& w) { w.move(2, State::finalized); }}},
      .broken = [](const World& world) { return world.violation; },
      .state =
          [](const World& world) {
            std::string text =
                std::to_string(static_cast<int>(world.command)) + (world.is_brought_down ? '+' : '-');
            for (const State state : world.nodes) text += std::to_string(static_cast<int>(state));
            if (!world.bring_up) return text + " at rest";
            const auto step = BringUp(*world.bring_up).next();
            return text + std::to_string(world.steps) + std::to_string(step->node) +
                   std::string(step->transition) + (world.bring_up->failure() ? '!' : ' ');
          }};
  for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(Command::cleanup); ++i)
    sequences.events.push_back({"command " + std::to_string(i), [i](World& w) { w.begin(*command_of(i)); }});
  test::expect_unbroken("bring_up", sequences, test::sequence_depth(16));
}

}  // namespace
}  // namespace bw::lifecycle
