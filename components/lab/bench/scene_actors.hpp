// Movers by a script: each by a rule of its own, whatever the others do. Metres, seconds.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "components/lab/bench/scene_drive.hpp"

namespace bw {

struct SceneActor {
  using Rule = std::function<void(double time, const SceneRobot& robot, SceneDisc& disc)>;
  SceneDisc disc;
  /// Moves it kSceneStep on from `time` since the drive began, and sets its velocity. May keep a state, which is copied
  /// with it. Empty: on with its velocity for ever.
  Rule rule = {};
};

class SceneActors final : public SceneMovers {
 public:
  explicit SceneActors(std::vector<SceneActor> actors = {}) {
    for (SceneActor& actor : actors) {
      discs_.push_back(actor.disc);
      rules_.push_back(std::move(actor.rule));
    }
  }
  std::unique_ptr<SceneMovers> clone() const override { return std::make_unique<SceneActors>(*this); }
  const std::vector<SceneDisc>& discs() const override { return discs_; }
  void step(const SceneRobot& robot) override {
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      if (rules_[i])
        rules_[i](steps_ * kSceneStep, robot, discs_[i]);
      else
        discs_[i].position += kSceneStep * discs_[i].velocity;
    }
    ++steps_;
  }

 private:
  std::vector<SceneDisc> discs_;
  std::vector<SceneActor::Rule> rules_;
  int steps_ = 0;
};

}  // namespace bw
