// From finished submaps to where they lie on the map: loops are searched for, accepted, and the graph optimised, in
// pieces of work small enough to come between two scans.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "components/slam/loop_search.hpp"
#include "components/slam/pose_graph.hpp"
#include "components/slam/slam_options.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

struct LoopCounts {
  std::int64_t searched = 0;  ///< pairs of submaps
  std::int64_t found = 0;     ///< loops
  std::int64_t accepted = 0;
  std::int64_t visited = 0;  ///< poses and squares of branch and bound
  std::int64_t optimisations = 0;
  std::int64_t marginalised = 0;  ///< submaps that left
};

class LoopClosing {
 public:
  /// All of it while no work is left.
  struct State {
    std::vector<Submap> submaps;
    std::vector<Pose2> X_MS;
    std::vector<Edge> edges;
    std::vector<Loop> pending;  ///< wait for support
    UncertainPose newest_in_first;
    std::size_t turn = 0;  ///< of the candidates that are far
    LoopCounts counts;
  };
  /// `nodes`: those that the submaps name; outlives this. They leave with their submap.
  LoopClosing(const SlamOptions& options, Nodes& nodes) : options_(options), nodes_(nodes) {}
  /// Takes up what was left.
  LoopClosing(const SlamOptions& options, Nodes& nodes, State state)
      : options_(options), nodes_(nodes), known_(std::move(state)) {}
  /// With no work left.
  const State& state() const { return known_; }

  /// Of work that another thread does; both empty: it is done already.
  struct Pending {
    std::function<bool()> is_done;
    std::function<void()> wait;
  };
  /// Where work with the whole graph is done, which takes tens of milliseconds in a large one: it calls its argument,
  /// now or on another thread. What comes of it is the same; without it, all is done by advance().
  using Beside = std::function<Pending(std::function<void()>)>;
  void work_beside(Beside beside) { beside_ = std::move(beside); }
  /// Returns when nothing is under way beside.
  void wait() const {
    if (pending_.wait) pending_.wait();
  }

  void add(const Submap& submap) { waiting_.push_back(submap); }

  /// Compares one pair of submaps, or goes on with the graph: below a millisecond or a few. False: nothing is left to do.
  /// While something is under way beside it does nothing.
  bool advance();
  /// Begins an optimisation where loops came since the last one: those that the poses agree with wait for it.
  void settle();

  /// Of submaps that were taken up: those that wait are not among them.
  const std::vector<Submap>& submaps() const { return known_.submaps; }
  const std::vector<Pose2>& X_MS() const { return known_.X_MS; }
  const std::deque<Submap>& waiting() const { return waiting_; }
  const std::vector<Edge>& edges() const { return known_.edges; }
  const LoopCounts& counts() const { return known_.counts; }
  /// Pose of the newest of them in the first, with the covariance of all edges together.
  const UncertainPose& newest_in_first() const { return known_.newest_in_first; }
  /// The same of any of them that is there.
  UncertainPose in_first(std::size_t submap) const;
  /// Counts up whenever submaps moved or left.
  std::int64_t revision() const { return known_.counts.optimisations + known_.counts.marginalised; }

 private:
  struct View;
  struct Search;
  void take_up();
  void begin_search();
  void open_search();
  /// Frames of a submap (S) and of so many before it on the same drive, in S.
  std::vector<Pose2> frames_before(std::size_t submap, std::size_t before) const;
  /// Of the same, some scans.
  Sights sights(std::size_t submap, std::size_t before) const;
  /// Walls of the newest submap and, if `before` is not 0, of the one so many before it on the same drive.
  void look(View& view, std::size_t before) const;
  bool accept();                        ///< true: a loop that poses must move for
  void place(std::vector<Pose2> X_MS);  ///< after an optimisation
  void marginalise_if_seen_again(std::size_t submap);

  SlamOptions options_;
  Nodes& nodes_;
  std::deque<Submap> waiting_;
  State known_;
  std::shared_ptr<Search> search_;  ///< of the newest submap
  std::shared_ptr<Optimisation> optimisation_;
  Beside beside_;
  Pending pending_;                  ///< what is under way beside
  std::vector<std::size_t> review_;  ///< submaps that the newest may have seen again: may they leave?
  std::vector<std::size_t> around_;  ///< all that may have seen the same as these
  bool settled_ = true;              ///< no loop came since the last optimisation began
};

}  // namespace bw::slam
