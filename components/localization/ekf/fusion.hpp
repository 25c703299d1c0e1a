// One measurement into the state: prediction, gate, correction, bookkeeping. A pure function of both, so that
// replaying the same measurements from the same state gives the same bits.
#pragma once

#include <array>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"
#include "components/localization/verdict.hpp"

namespace bw::localization {

struct FusionResult {
  Verdict verdict = Verdict::accepted;
  double nis = 0.0;  ///< normalised innovation squared before the correction; 0 for motion
  int dof = 0;
};

class Fusion {
 public:
  explicit Fusion(const EkfOptions& options);

  /// Stamps must not go back. The measurement must have passed check().
  FusionResult apply(EkfState& state, const Measurement& measurement) const;

  const EkfOptions& options() const { return options_; }

 private:
  EkfOptions options_;
  std::array<double, 4> thresholds_{};  // by degrees of freedom
};

}  // namespace bw::localization
