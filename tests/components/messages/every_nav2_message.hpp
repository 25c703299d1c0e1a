// What Nav2's actions and services put on the wire, in one layout; in the same order for every layout.
#pragma once

#include <memory>
#include <vector>

#include "components/messages/nav2_layouts.hpp"
#include "tests/idl/any_message.hpp"

namespace bw::test {

using Messages = std::vector<std::unique_ptr<AnyMessage>>;

template <class... M>
void append(Messages& to) {
  (to.push_back(std::make_unique<MessageOf<M>>()), ...);
}

template <class A>
void append_action(Messages& to) {
  append<typename A::SendGoal::Request, typename A::SendGoal::Response, typename A::GetResult::Request,
         typename A::GetResult::Response, typename A::FeedbackMessage>(to);
}

template <class S>
void append_service(Messages& to) {
  append<typename S::Request, typename S::Response>(to);
}

template <class Nav2>
Messages every_nav2_message() {
  Messages messages;
  append_action<typename Nav2::FollowPath>(messages);
  append_action<typename Nav2::ComputePathToPose>(messages);
  append_action<typename Nav2::ComputePathThroughPoses>(messages);
  append_action<typename Nav2::NavigateToPose>(messages);
  append_action<typename Nav2::NavigateThroughPoses>(messages);
  append_action<typename Nav2::FollowWaypoints>(messages);
  append_action<typename Nav2::Spin>(messages);
  append_action<typename Nav2::BackUp>(messages);
  append_action<typename Nav2::DriveOnHeading>(messages);
  append_action<typename Nav2::Wait>(messages);
  append_service<typename Nav2::ClearEntireCostmap>(messages);
  append_service<typename Nav2::ClearCostmapAroundRobot>(messages);
  append_service<typename Nav2::ClearCostmapExceptRegion>(messages);
  append_service<typename Nav2::IsPathValid>(messages);
  return messages;
}

}  // namespace bw::test
