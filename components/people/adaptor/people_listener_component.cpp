// Adaptor: people whom another program sees (people_msgs/People) in; tracks with predictions out. In place of
// the own detector.
#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <people_msgs/msg/people.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/people.hpp"
#include "components/people/adaptor/people_message.hpp"
#include "components/people/adaptor/prediction_weights.hpp"
#include "components/people/heard_people.hpp"
#include "components/people/prediction/predictor.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw::people {
namespace {

const Duration kHeardMarkerLifetime = Duration::milliseconds(500);

struct PeopleListenerOptions {
  double timeout = 1.0;
  HeardPeopleOptions people;
  PredictionOptions prediction;

  template <class Visitor>
  void fields(Visitor& v) {
    v("timeout", timeout,
      {.unit = "s",
       .min = 0.01,
       .max = 10,
       .doc = "people of a stamp that is farther from now are not used"});
    people.fields(v);
    v("prediction", prediction, {.doc = "where people will be"});
  }
  std::optional<std::string> violated_rule() const {
    if (prediction.model == PredictionModel::social_force)
      return "prediction.model must not be social_force: no walls are known here";
    return std::nullopt;
  }
};

}  // namespace

class PeopleListenerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<PeopleListenerOptions>(
        [this](const PeopleListenerOptions& changed, const Tick&) {
          options_ = changed;
          predictor_->set_options(changed.prediction);
        },
        {"prediction.model", "prediction.weights"});
    predictor_.emplace(options_.prediction, head_of(setup, options_.prediction));
    odom_frame_ = setup.frame("odom");
    transforms_ = setup.transforms();
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    tracks_ = setup.output<bandwagon_msgs::msg::Tracks>("tracks");
    markers_ = setup.output<visualization_msgs::msg::MarkerArray>("people_markers");
    setup.input<people_msgs::msg::People>(
        "people", Qos::standard(),
        [this](const people_msgs::msg::People& message, const Tick& tick) { hear(message, tick.now); });
  }

 private:
  /// Nothing is published of a message that is not used, so that the age of tracks tells.
  void hear(const people_msgs::msg::People& message, Time now) {
    const ReadPeople read = read_people(message, now, options_.timeout, odom_frame_, *transforms_);
    note(read.fault);
    if (!read.fault.empty()) return;
    const Time stamp = read.heard.time;
    std::vector<TrackedPerson> people = heard_.take(read.heard.people, stamp, options_.people);
    predictor_->predict(people, {}, stamp);
    const std_msgs::msg::Header header = make_header(odom_frame_, stamp);
    tracks_.publish(to_tracks(people, header));
    if (markers_.has_readers()) markers_.publish(to_markers(people, kHeardMarkerLifetime, header));
  }

  void note(const std::string& fault) {
    if (!fault_.is_news(fault)) return;
    using Level = DiagnosticReporter::Level;
    if (fault.empty()) {
      diagnostics_->report(Level::ok, "people are heard");
    } else {
      log_.warn("a message of people is not used: {}", fault);
      diagnostics_->report(Level::error, "people are not used: " + fault);
    }
  }

  PeopleListenerOptions options_;
  HeardPeople heard_;
  std::optional<Predictor> predictor_;
  Complaint fault_{"none came yet"};
  std::string odom_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<bandwagon_msgs::msg::Tracks> tracks_;
  Output<visualization_msgs::msg::MarkerArray> markers_;
};

BW_COMPONENT(PeopleListenerComponent, "people_listener")

}  // namespace bw::people
