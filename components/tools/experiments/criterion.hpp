// Something an experiment must show.
#pragma once

#include <string>

namespace bw {

struct Criterion {
  std::string name;
  std::string asked;  ///< such as "<= 0.04"
  double measured = 0.0;
  bool met = false;
};

}  // namespace bw
