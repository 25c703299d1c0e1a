// What the parts of WireRobot share: a participant of their own, who is there, who listens, and the server's
// thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/ros_distro.hpp"
#include "runtime/dds/participant.hpp"
#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw::foxglove {

/// Brings work to the server's thread, from any thread.
using Post = std::function<void(std::function<void()>)>;

/// Work that DDS threads ask for, many times, and that the server's thread does once. It may outlive what it
/// works for.
class PostedTask {
 public:
  PostedTask(Post post, std::function<void()> work)
      : state_(std::make_shared<State>(std::move(post), std::move(work))) {}
  ~PostedTask() { state_->work = nullptr; }
  PostedTask(const PostedTask&) = delete;
  PostedTask& operator=(const PostedTask&) = delete;

  /// For DDS threads: may be called when this is gone.
  [[nodiscard]] std::function<void()> bell() const {
    return [state = state_] { ring(state); };
  }
  void ring() const { ring(state_); }

 private:
  struct State {
    State(Post p, std::function<void()> w) : post(std::move(p)), work(std::move(w)) {}
    const Post post;
    std::function<void()> work;  ///< of the server's thread, which also ends it
    std::atomic<bool> is_asked = false;
  };
  static void ring(const std::shared_ptr<State>& state) {
    if (state->is_asked.exchange(true)) return;
    state->post([state] {
      state->is_asked = false;  // before the work: who rings from now on is not forgotten
      if (state->work) state->work();
    });
  }

  std::shared_ptr<State> state_;
};

/// Of the server's thread, but for `participant` and `announcement`.
struct WireLink {
  WireLink(const dds::Network& network, const std::string& node, AnnouncementOptions announcing,
           Post to_server, std::function<void()> on_names)
      : post(std::move(to_server)),
        participant({.network = network, .receive_buffer = kReceiveBuffer}),
        directory(participant, std::move(on_names)),
        announcement(participant, std::move(announcing)) {
    announcement.add({.node_namespace = "/", .name = node, .readers = {}, .writers = {}});
    announcement.publish();
  }

  /// Tells others of ends that came or go. Once for all that change in a moment.
  void announce() {
    if (std::exchange(has_new_ends, false)) announcement.publish();
  }
  template <class End>
  void add(const End& end) {
    announcement.add(end);
    has_new_ends = true;
  }
  template <class End>
  void remove(const End& end) {
    announcement.remove(end);
    has_new_ends = true;
  }

  bool is_own(const dds::Guid& end) const { return dds::same_participant(end, participant.guid()); }
  /// Kept for who listens later.
  void say(int level, const std::string& message) {
    if (said.size() < kMaxSaid) said.emplace_back(level, message);
    if (listener != nullptr) listener->on_status(level, message);
  }

  static constexpr std::uint32_t kReceiveBuffer = 4 << 20;  // [bytes]
  static constexpr std::size_t kMaxSaid = 100;

  Post post;
  dds::Participant participant;
  NodeDirectory directory;
  NodeAnnouncement announcement;
  bool has_new_ends = false;
  RobotListener* listener = nullptr;  ///< null: nobody listens
  std::vector<std::pair<int, std::string>> said;
};

}  // namespace bw::foxglove
