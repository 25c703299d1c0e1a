// What drives were like, over all of them: acknowledgements, what new paths did to the speed, contacts.
#pragma once

#include <string>
#include <vector>

#include "tests/interop/nav2_tree/drive.hpp"

namespace bw::test {

class DriveFigures {
 public:
  /// A line about the drive.
  std::string add(int seed, const DriveReport& report);
  /// A few lines about all.
  std::string summary() const;

  /// By how much dips after new paths are deeper than those half a second later, on average [m/s].
  double added_dip() const;
  std::size_t preemptions() const { return dips_.size(); }
  int replaced_that_ended_otherwise() const { return replaced_otherwise_; }

 private:
  std::vector<double> acknowledgements_;  ///< [s] of goals and cancels
  std::vector<double> clears_;            ///< [s] of the services
  int unanswered_ = 0;
  std::vector<double> dips_, dips_in_between_;  ///< [m/s]
  std::vector<double> pose_ages_;               ///< [s] the oldest of each drive
  std::vector<double> times_;                   ///< [s]
  int recoveries_ = 0;
  int contacts_ = 0;
  int replaced_otherwise_ = 0;
};

}  // namespace bw::test
