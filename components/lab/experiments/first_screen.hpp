// How every report of an experiment begins: what was reproduced and what was not.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// Texts as those of a document, but for `judged` and `tuned`, which are plain.
struct FirstScreen {
  std::string title;
  std::string about;                         ///< which parts of the source, what the report shows
  std::string judged;                        ///< what the exit status stands for
  std::vector<Criterion> criteria = {};      ///< of what is judged
  std::vector<std::string> not_judged = {};  ///< what is only reported, or cannot be reproduced, and why
  std::vector<std::string> tuned = {};       ///< chosen with the published values in view
};

/// A document with title, outcome and criteria.
report::Document begin_report(const FirstScreen& screen);

report::Table criteria_table(const std::vector<Criterion>& criteria);

/// "gain of EDWA: 0.00412, asked >= 0.01"; counts without decimals where none are asked for.
std::string missed_in_words(const Criterion& criterion);

}  // namespace bw
