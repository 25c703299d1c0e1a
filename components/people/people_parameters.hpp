// Parameters of the people component: each part's own.
#pragma once

#include "components/people/detector/detector_options.hpp"
#include "components/people/prediction/prediction_options.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

struct PeopleParameters {
  DetectorOptions detector;
  TrackerOptions tracker;
  PredictionOptions prediction;

  template <class Visitor>
  void fields(Visitor& v) {
    v("detector", detector, {.doc = "sweep to legs"});
    v("tracker", tracker, {.doc = "legs to people"});
    v("prediction", prediction, {.doc = "where people will be"});
  }
};

}  // namespace bw::people
