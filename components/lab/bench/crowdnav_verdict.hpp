// Whether the contact that ended one of CrowdNav's test cases could have been avoided (possible/theory.md
// 8.10, protocols.md 8.11).
#pragma once

#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/lab/bench/crowdnav_people.hpp"

namespace bw {

/// Where the people of a case were at the beginnings of all its steps, and straight on in between.
using CrowdNavWalks = std::vector<std::vector<CrowdNavAgent>>;

/// The contacts of a robot that moved so, with people who walked so. What they do after the last of these
/// nobody knows.
std::vector<JudgedContact> judge_crowdnav(const std::vector<possible::MotionState>& motion,
                                          const CrowdNavWalks& walks, const Limits& limits);

}  // namespace bw
