// Who writes: the ends of this host, and in real time everybody whom discovery knows.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/ports.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw {

struct Actor;

/// From any thread.
class WriterNames final : public Writers {
 public:
  explicit WriterNames(const std::vector<std::unique_ptr<Actor>>& actors) : actors_(actors) {}
  /// Others are known from now on: not in lock-step. The participant must be there until disconnect().
  void connect(dds::Participant& participant);
  /// Nobody else is known any more.
  void disconnect();

  std::string node_of(const dds::Guid& writer) override;
  std::optional<Duration> lease_of(const dds::Guid& writer) override;

 private:
  const Actor* own(const dds::Guid& writer) const;

  const std::vector<std::unique_ptr<Actor>>& actors_;
  std::mutex mutex_;
  dds::Participant* participant_ = nullptr;
  std::optional<NodeDirectory> directory_;
};

}  // namespace bw
