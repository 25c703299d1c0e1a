// Which frame is where, over time: the last seconds of every parent-child transform, looked up along the tree
// with interpolation. X_PC is the pose of the child frame C in its parent P. Plain C++: whoever reads /tf
// feeds it.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

class TransformTree {
 public:
  explicit TransformTree(Duration history = Duration::milliseconds(10'000)) : history_(history) {}

  /// Ignores (false) a transform that is not finite, has no unit quaternion within 1e-3, is from itself to
  /// itself, or is older than the history. A later parent for the same child replaces the former one. Five in
  /// a row that are half a second older than the newest are a clock that went back: what was known of the
  /// child is forgotten.
  bool set(const std::string& parent, const std::string& child, Time stamp, const Eigen::Isometry3d& X_PC,
           bool is_static);

  /// X_TS: pose of `source` in `target` at `time`; Time{} means the newest common instant. Nothing when the
  /// frames are not connected or when `time` lies outside what is known (no extrapolation).
  std::optional<Eigen::Isometry3d> lookup(const std::string& target, const std::string& source,
                                          Time time = {}) const;
  /// The same, projected to the plane.
  std::optional<Pose2> lookup_planar(const std::string& target, const std::string& source,
                                     Time time = {}) const;
  /// The newest instant of which `lookup` knows; the far future where nothing between the two moves. Nothing when
  /// they are not connected.
  std::optional<Time> newest(const std::string& target, const std::string& source) const;

 private:
  struct Stamped {
    Time stamp;
    Eigen::Isometry3d X_PC;
  };
  struct Link {
    std::string parent;
    bool is_static = false;
    std::deque<Stamped> samples;  ///< rising in time
    int behind = 0;               ///< how many in a row were much older than the newest
  };

  /// The frames from each of two to its root, and the first that both have.
  struct Connection {
    std::vector<std::string> from_target, from_source;
    std::string ancestor;
  };

  std::vector<std::string> chain_to_root(const std::string& frame) const;
  std::optional<Connection> connection(const std::string& target, const std::string& source) const;
  std::optional<Eigen::Isometry3d> pose_in_ancestor(const std::string& frame, const std::string& ancestor,
                                                    Time time) const;
  Time newest_common(const Connection& connection) const;

  Duration history_;
  std::map<std::string, Link> links_;  ///< by child
};

Pose2 planar(const Eigen::Isometry3d& X);
Eigen::Isometry3d spatial(const Pose2& X);

}  // namespace bw
