// Local planners by the name a graph gives them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/mppi/mppi_options.hpp"
#include "components/local_planner/teb/prediction_options.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/planning.hpp"
#include "runtime/base/any_options.hpp"

namespace bw {

/// What PTEB adds to the choice between topologies (book 6.4).
struct PtebOptions {
  double hrvo_angle_weight = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("hrvo_angle_weight", hrvo_angle_weight,
      {.min = 0,
       .max = 100,
       .doc = "delta_hrvo of (3.12): cost per radian between a band and the HRVO direction; raise it to "
              "follow HRVO against shorter ways"});
  }
};

/// Parameters of planners that registered with options of their own, a section for each; at first their
/// defaults. Planners registered later are not in it.
class PlannerSections {
 public:
  PlannerSections();

  /// Throws std::out_of_range for a planner without options of its own.
  const AnyOptions& of(const std::string& planner) const { return sections_.at(planner); }
  template <class Visitor>
  void fields(Visitor& v) {
    for (auto& [name, options] : sections_) v(name, options, {.doc = "parameters of this planner alone"});
  }

 private:
  std::map<std::string, AnyOptions> sections_;
};

/// Parameters of all local planners: what they share, then a section for each idea.
struct LocalPlannerOptions {
  DrivingOptions driving;
  dwa::DwaOptions dwa;
  dwa::EdwaOptions edwa;
  hrvo::HrvoOptions hrvo;
  mppi::MppiOptions mppi;
  teb::TebOptions teb;
  homotopy::HomotopyOptions homotopy;
  PtebOptions pteb;
  teb::PredictionOptions eteb = teb::default_eteb_prediction();
  PlannerSections others;

  template <class Visitor>
  void fields(Visitor& v) {
    driving.fields(v);
    v("dwa", dwa, {.doc = "dynamic window approach"});
    v("edwa", edwa, {.doc = "what EDWA changes in it"});
    v("hrvo", hrvo, {.doc = "hybrid reciprocal velocity obstacles"});
    v("mppi", mppi, {.doc = "model predictive path integral, as Nav2 ships it"});
    v("teb", teb, {.doc = "timed elastic band; teb_homotopy, pteb and eteb too"});
    v("homotopy", homotopy, {.doc = "bands in several topologies: teb_homotopy, pteb, eteb"});
    v("pteb", pteb, {.doc = "what PTEB adds: the HRVO direction in the choice"});
    v("eteb", eteb, {.doc = "what ETEB adds: predicted obstacles and how sure they are"});
    others.fields(v);
  }
};

/// As the parameter `algorithm` knows them, sorted; the texts live as long as the program.
std::vector<std::string_view> planner_names();

/// Throws std::runtime_error naming the known planners when `name` is none of them.
std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const LocalPlannerOptions& options);

}  // namespace bw
