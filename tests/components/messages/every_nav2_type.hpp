// Visits every message of Nav2's actions and services in two layouts at once.
#pragma once

#include "components/messages/nav2_layouts.hpp"

namespace bw::test {

template <class A, class B, class F>
void every_action_message(F&& f) {
  f.template operator()<typename A::SendGoal::Request, typename B::SendGoal::Request>();
  f.template operator()<typename A::SendGoal::Response, typename B::SendGoal::Response>();
  f.template operator()<typename A::GetResult::Request, typename B::GetResult::Request>();
  f.template operator()<typename A::GetResult::Response, typename B::GetResult::Response>();
  f.template operator()<typename A::FeedbackMessage, typename B::FeedbackMessage>();
}

template <class A, class B, class F>
void every_service_message(F&& f) {
  f.template operator()<typename A::Request, typename B::Request>();
  f.template operator()<typename A::Response, typename B::Response>();
}

/// f.operator()<M of A, M of B>() for each.
template <class A, class B, class F>
void every_nav2_type(F&& f) {
  every_action_message<typename A::FollowPath, typename B::FollowPath>(f);
  every_action_message<typename A::ComputePathToPose, typename B::ComputePathToPose>(f);
  every_action_message<typename A::ComputePathThroughPoses, typename B::ComputePathThroughPoses>(f);
  every_action_message<typename A::NavigateToPose, typename B::NavigateToPose>(f);
  every_action_message<typename A::NavigateThroughPoses, typename B::NavigateThroughPoses>(f);
  every_action_message<typename A::FollowWaypoints, typename B::FollowWaypoints>(f);
  every_action_message<typename A::Spin, typename B::Spin>(f);
  every_action_message<typename A::BackUp, typename B::BackUp>(f);
  every_action_message<typename A::DriveOnHeading, typename B::DriveOnHeading>(f);
  every_action_message<typename A::Wait, typename B::Wait>(f);
  every_service_message<typename A::ClearEntireCostmap, typename B::ClearEntireCostmap>(f);
  every_service_message<typename A::ClearCostmapAroundRobot, typename B::ClearCostmapAroundRobot>(f);
  every_service_message<typename A::ClearCostmapExceptRegion, typename B::ClearCostmapExceptRegion>(f);
  every_service_message<typename A::IsPathValid, typename B::IsPathValid>(f);
}

}  // namespace bw::test
