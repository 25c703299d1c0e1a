// What the graph says of evaluation beyond its judgements: how often it tells, what it draws.
#pragma once

#include <string>

#include "components/evaluation/score_keeper.hpp"
#include "runtime/base/choice.hpp"

namespace bw {

/// What a score card is of.
enum class Scored {
  drive,   ///< to the goals that the navigator reports
  drives,  ///< everything from the first goal on: others follow while the run lasts
  run      ///< everything from the first truth on: nobody drives, as on a recording
};
constexpr auto choice_table(Scored) {
  using enum Scored;
  return choices<Scored>({{drive, "drive"}, {drives, "drives"}, {run, "run"}});
}

struct EvaluationParameters : EvaluationOptions {
  Scored scored = Scored::drive;
  /// [Hz] score cards per second while driving
  static constexpr double kRate = 2.0;
  std::string svg;
  std::string title = "Bandwagon";
  double time_limit = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    EvaluationOptions::fields(v);
    v("scored", scored,
      {.doc =
           "drive: to the goals that the navigator reports; drives: from the first goal to the end of the run, "
           "with the outcome of the last goal (set by run --stay); run: the whole run, as beside a recording, "
           "where only the error of the pose is of interest"});
    v("svg", svg, {.doc = "file for the picture of the run; empty: none"});
    v("title", title, {.doc = "heading of the picture"});
    v("time_limit", time_limit,
      {.unit = "s",
       .min = 0,
       .max = 1e9,
       .doc = "when the run ends (set by run --for and by evaluate): who drives until then is called late in "
              "the picture; 0: none"});
    v.retired({"rate"}, "a constant of evaluation_parameters.hpp");
  }
};

}  // namespace bw
