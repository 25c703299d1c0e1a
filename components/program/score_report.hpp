// How the drives of a bag went, for people, for scripts, and as an exit status.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "components/program/score_bag.hpp"

namespace bw {

struct ScoreReport {
  /// `reached` of a drive is null where that is not known, and so are its figures where nothing of it is in
  /// the bag.
  nlohmann::json json;
  std::string text;
  /// 0: every goal was reached; 1: one was not; 3: none is known to be missed, and of one, or of the whole
  /// bag, nothing is known.
  int exit_status = 0;
};

ScoreReport report_of(const BagScore& score);

}  // namespace bw
