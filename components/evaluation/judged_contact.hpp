// The contacts of a drive with what could have been done about them (possible/theory.md 8.10).
#pragma once

#include <vector>

#include "components/evaluation/contact_diary.hpp"
#include "components/evaluation/possible/contact_verdict.hpp"
#include "components/evaluation/run_recorder.hpp"

namespace bw {

struct JudgedContact {
  ContactRecord record;
  bool is_judged = false;  ///< false: the robot's limits are not known, or it was one of too many
  possible::ContactVerdict verdict;
};

/// The longest time before a contact that is searched [s]: who can be saved then could be at any time before.
inline constexpr double kLongestSearch = 16.0;

/// Each of `contacts`, in their order, from when its person came to be on, and from the end of any before it
/// that could not be avoided; who comes to be in contact cannot be avoided. The first 20 are judged. `drive`:
/// states by rising time; `known_until`: after it nobody knows where people were [s].
std::vector<JudgedContact> judge_contacts(const std::vector<ContactRecord>& contacts,
                                          const possible::SearchScene& scene,
                                          const std::vector<possible::MotionState>& drive, double known_until,
                                          const Limits& limits);

/// Of a recorded drive whose people walked as they did, linear between its moments. Not judged where its
/// limits are not known.
std::vector<JudgedContact> judge_contacts(const RunRecording& recording);

/// True when success was impossible: there were contacts, and none of them could have been avoided.
/// `counted`: how many contacts there were, walls included.
bool is_excused(const std::vector<JudgedContact>& contacts, int counted);

}  // namespace bw
