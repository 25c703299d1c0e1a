// Why a drive failed, as far as its recording tells (possible/theory.md 8.10): one cause of a list, for
// counting and for looking on.
#pragma once

#include <array>
#include <optional>

#include "components/evaluation/contact_diary.hpp"
#include "components/evaluation/run_recorder.hpp"

namespace bw {

/// In the order in which they are asked: the first that holds is the cause.
enum class FailureCause {
  stuck,           ///< late, and it hardly moved in its last seconds
  late,            ///< the goal was not reached, without a contact that counts
  thing,           ///< it touched something that is nobody: a wall, a pillar
  mid_floor,       ///< the person came to be, or was gone, in mid-floor (ContactRecord)
  robot_closing,   ///< WhoHit: the robot's own speed did it
  turning_walker,  ///< the person was not where they had headed 2 s before
  robot_standing,  ///< WhoHit: a walker who went straight on over a robot that stood
  from_behind,     ///< WhoHit: likewise, the robot moved
  from_side,
  from_ahead
};
inline constexpr std::array kAllFailureCauses = {FailureCause::stuck,          FailureCause::late,
                                                 FailureCause::thing,          FailureCause::mid_floor,
                                                 FailureCause::robot_closing,  FailureCause::turning_walker,
                                                 FailureCause::robot_standing, FailureCause::from_behind,
                                                 FailureCause::from_side,      FailureCause::from_ahead};

/// "turning_walker".
const char* text_of(FailureCause cause);

struct FoundCause {
  FailureCause cause = FailureCause::late;
  /// Of the person at the contact, from where they would have been, straight on at their velocity 2 s before
  /// (when they came, if later) [m].
  std::optional<double> off_course;
};

/// `contact`: the one that made the drive fail; nothing where none did. `reached`: the goal was.
FoundCause cause_of(const RunRecording& recording, const std::optional<ContactRecord>& contact, bool reached);

}  // namespace bw
