// What the graph says of evaluation beyond its judgements: how often it tells, what it draws.
#pragma once

#include <string>

#include "components/evaluation/score_keeper.hpp"

namespace bw {

struct EvaluationParameters : EvaluationOptions {
  double rate = 2.0;
  std::string svg;
  std::string title = "Bandwagon";
  double time_limit = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    EvaluationOptions::fields(v);
    v("rate", rate, {.unit = "Hz", .min = 0.1, .max = 50, .doc = "score cards per second while driving"});
    v("svg", svg, {.doc = "file for the picture of the run; empty: none"});
    v("title", title, {.doc = "heading of the picture"});
    v("time_limit", time_limit,
      {.unit = "s",
       .min = 0,
       .max = 1e9,
       .doc = "when the run ends (set by run --for and by evaluate): who drives until then is called late in "
              "the picture; 0: none"});
  }
};

}  // namespace bw
