// The watch over the names of one process, on the wire. In real time only: lock-step does not hear the
// outside.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/host/duplicate_name_watch.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw {

struct Actor;

std::vector<OwnNode> find_own_nodes(const std::vector<Actor*>& local);

/// From any thread.
class DuplicateNameGuard {
 public:
  /// The participant must outlive this.
  DuplicateNameGuard(dds::Participant& participant, std::vector<OwnNode> nodes)
      : participant_(participant), directory_(participant), watch_(std::move(nodes)) {}

  std::vector<DuplicateNameWatch::News> look();
  /// Who stands beside our node of this full name at this moment; empty: nobody.
  std::string rivals_of(const std::string& node);
  std::map<std::string, DuplicateNameWatch::News> states();

 private:
  DomainView view(const std::vector<dds::Endpoint>& endpoints);

  std::mutex mutex_;
  dds::Participant& participant_;
  NodeDirectory directory_;
  DuplicateNameWatch watch_;
  std::uint64_t changes_ = 0;
};

}  // namespace bw
