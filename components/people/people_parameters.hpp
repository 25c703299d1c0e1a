// Parameters of the people component: each part's own.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "components/people/detector/detector_options.hpp"
#include "components/people/prediction/prediction_options.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

struct OtherDetectorOptions {
  std::vector<std::string> people_topics;
  /// [s] their messages of a stamp that is farther from now are not used
  static constexpr double kPeopleTimeout = 0.5;
  /// [s] another detector that is silent for longer is told to be missing: it is to speak once a second
  static constexpr double kPeopleSilence = 1.0;
  /// of people with reliability 0, as of a detector that tells none
  static constexpr double kUntoldReliability = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("people_topics", people_topics,
      {.doc =
           "people_msgs/People of other detectors (a camera), fused with what the lasers see; none: lasers alone"});
    v.retired({"people_timeout", "people_silence", "untold_reliability"},
              "a constant of people_parameters.hpp");
  }
};

struct PeopleParameters {
  std::vector<std::string> scan_topics = {"scan"};
  OtherDetectorOptions others;
  DetectorOptions detector;
  TrackerOptions tracker;
  PredictionOptions prediction;
  double obstacles_timeout = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("scan_topics", scan_topics,
      {.first = true,
       .doc =
           "sensor_msgs/LaserScan of the lasers at the height of legs, each with its own mount: [scan, scan_rear]; the "
           "first is the one that errors of odometry are taken from"});
    others.fields(v);
    v("detector", detector, {.doc = "from a sweep to legs"});
    v("tracker", tracker, {.doc = "from legs to people"});
    v("prediction", prediction, {.doc = "where people will be"});
    v("obstacles_timeout", obstacles_timeout,
      {.unit = "s", .min = 0, .max = 10, .doc = "older obstacles are no walls for social_force"});
  }

  std::optional<std::string> violated_rule() const {
    std::vector<std::string> topics = scan_topics;
    topics.insert(topics.end(), others.people_topics.begin(), others.people_topics.end());
    if (topics.empty()) return "scan_topics and people_topics must not both be empty";
    std::ranges::sort(topics);
    if (topics.front().empty()) return "scan_topics and people_topics must hold names";
    if (std::ranges::adjacent_find(topics) != topics.end())
      return "scan_topics and people_topics must not name a topic twice";
    return std::nullopt;
  }
};

}  // namespace bw::people
