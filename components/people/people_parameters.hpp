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
  double obstacles_timeout = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("detector", detector, {.doc = "from a sweep to legs"});
    v("tracker", tracker, {.doc = "from legs to people"});
    v("prediction", prediction, {.doc = "where people will be"});
    v("obstacles_timeout", obstacles_timeout,
      {.unit = "s", .min = 0, .max = 10, .doc = "older obstacles are no walls for social_force"});
  }
};

}  // namespace bw::people
