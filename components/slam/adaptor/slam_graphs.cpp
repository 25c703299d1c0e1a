// Maps that are saved with all that SLAM knows, gone on with, and where the robot is in them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <slam_toolbox/srv/deserialize_pose_graph.hpp>
#include <slam_toolbox/srv/serialize_pose_graph.hpp>

#include "components/files/map_file.hpp"
#include "components/messages/geometry.hpp"
#include "components/slam/adaptor/slam_component.hpp"
#include "components/slam/files/graph_disk.hpp"

namespace bw::slam {
namespace {

using slam_toolbox::srv::DeserializePoseGraph;
using slam_toolbox::srv::SerializePoseGraph;

constexpr int kPiecesOfSearch = 150;  // for each scan: nothing else is to be done then
constexpr SearchWindow kUsualWindow{1.0, 1.0, 0.6};
constexpr std::uint8_t kRefused = 255;

SerializePoseGraph::Response written(std::uint8_t result) {
  SerializePoseGraph::Response response;
  response.result(result);
  return response;
}

// The type has no result; as that of serialize_map.
DeserializePoseGraph::Response was_read(bool done) {
  DeserializePoseGraph::Response response;
  response.structure_needs_at_least_one_member(done ? 0 : kRefused);
  return response;
}

std::filesystem::path path_of_graph(const std::filesystem::path& folder, std::filesystem::path name) {
  if (name.extension() == ".posegraph") name.replace_extension();
  return path_of_map(folder, name).replace_extension(".posegraph");
}

// Three standard deviations of what somebody gave.
SearchWindow window_of(const Eigen::Matrix3d& covariance) {
  if (!covariance.allFinite() || covariance.isZero()) return kUsualWindow;
  const auto three = [&](int axis) { return 3.0 * std::sqrt(std::max(0.0, covariance(axis, axis))); };
  const double reach = std::clamp(std::max(three(0), three(1)), 0.5, 2.0);
  return {reach, reach, std::clamp(three(2), 0.3, 1.0)};
}

std::string text(const Pose2& X) { return fmt::format("({:.2f}, {:.2f}, {:.2f})", X.x, X.y, X.theta); }

}  // namespace

void SlamComponent::offer_graph_services(Setup& setup) {
  setup.service<SerializePoseGraph>(
      "slam_toolbox/serialize_map",
      [this](const SerializePoseGraph::Request& request, const Reply<SerializePoseGraph>& reply,
             const Tick&) {
        const auto refuse = [this, reply](const std::exception& error) {
          log_.error("serialize_map: {}", error.what());
          reply(written(kRefused));
        };
        try {
          if (slam_->nodes().empty()) throw std::runtime_error("there is no map yet");
          const std::filesystem::path file = path_of_graph(folder_, request.filename());
          if (!parameters_.overwrite && std::filesystem::exists(std::filesystem::symlink_status(file)))
            throw std::runtime_error(file.string() + " exists already, and is not to be overwritten");
          save([this, file, reply, refuse] {
            const auto graph = std::make_shared<const SavedGraph>(SavedGraph{X_MW_, slam_->save()});
            return [this, file, reply, refuse, graph] {
              try {
                write_graph_file(file, *graph);
                log_.info("the map is saved to be gone on with: {}", file.string());
                reply(written(slam_toolbox::srv::SerializePoseGraph_Response_Constants::RESULT_SUCCESS));
              } catch (const std::exception& error) {
                refuse(error);
              }
            };
          });
        } catch (const std::exception& error) {
          refuse(error);
        }
      },
      [](const std::string&) { return written(kRefused); });
  setup.service<DeserializePoseGraph>(
      "slam_toolbox/deserialize_map",
      [this](const DeserializePoseGraph::Request& request, const Tick&) {
        namespace match = slam_toolbox::srv::DeserializePoseGraph_Request_Constants;
        try {
          const Pose2 given{request.initial_pose().x(), request.initial_pose().y(),
                            wrap_angle(request.initial_pose().theta())};
          const auto type = request.match_type();
          if (type < match::UNSET || type > match::LOCALIZE_AT_POSE)
            throw std::runtime_error(fmt::format("match_type {}: must lie within 0 and 3", type));
          if (type >= match::START_AT_GIVEN_POSE && !is_finite(given))
            throw std::runtime_error("initial_pose: must be finite");
          SavedGraph graph = read_graph_file(path_of_graph(folder_, request.filename()));
          if (graph.slam.nodes.empty())
            throw std::runtime_error(request.filename() + ": the map has no scan");
          std::optional<Pose2> X_MB;
          if (type == match::START_AT_FIRST_NODE) X_MB = graph.X_MW;
          if (type >= match::START_AT_GIVEN_POSE) X_MB = given;
          continue_map(std::move(graph), X_MB);
          log_.info("{}: {} scans, {} submaps; the robot is {}", request.filename(), slam_->nodes().size(),
                    slam_->submaps(), X_MB ? "said to be at " + text(*X_MB) : "looked for in all of the map");
        } catch (const std::exception& error) {
          log_.error("deserialize_map: {}", error.what());
          return was_read(false);
        }
        return was_read(true);
      },
      [](const std::string&) { return was_read(false); });
}

void SlamComponent::continue_map(SavedGraph graph, const std::optional<Pose2>& X_MB) {
  const double resolution = graph.slam.options.resolution;
  if (resolution != parameters_.algorithm.resolution)
    log_.warn("the map's resolution, {} m, holds, and not the parameter's {} m", resolution,
              parameters_.algorithm.resolution);
  begin_map();
  options_.resolution = resolution;
  graph.slam.options = options_;
  X_MW_ = graph.X_MW;
  set_slam(std::make_unique<Slam>(std::move(graph.slam)));
  slam_->finish();
  painter_ = std::make_unique<MapPainter>(resolution, X_MW_);
  while (painter_->update(*slam_, 1000)) {
  }
  map_.begin(resolution);
  looks_for_place_ = true;
  given_ = X_MB;
  publish_map();
  while (to_gather_ > 0) gather_map();  // no scan waits for it: the robot has no place yet
}

bool SlamComponent::find_place(const Scan& scan, const Pose2& X_OB) {
  std::optional<Place> place;
  if (given_) {
    given_X_MO_ = *given_ * inverse(X_OB);
    given_.reset();
    map_to_odom_.jump(*given_X_MO_);
    is_told_ = true;
  }
  if (given_X_MO_) {
    place = place_near(*slam_, scan.points, inverse(X_MW_) * (*given_X_MO_ * X_OB), kUsualWindow);
  } else {
    if (!search_) search_ = std::make_unique<PlaceSearch>(*slam_);
    search_->add(scan, X_OB);
    for (int i = 0; i < kPiecesOfSearch && search_->advance(); ++i) {
    }
    place = search_->place();
  }
  if (!place) return false;
  begin_at(*place);
  return true;
}

void SlamComponent::begin_at(const Place& place) {
  search_.reset();
  given_X_MO_.reset();
  looks_for_place_ = false;
  is_kidnapped_ = false;
  watch_ = {};
  jumps_ = true;
  slam_->begin_at(place.submap, place.X_SB);
  log_.info("the robot is at {} in the map: {:.0f} % of the scan's points lie on its walls",
            text(X_MW_ * place.X_MB), 100.0 * place.inliers);
}

void SlamComponent::on_initial_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message) {
  const std::string& frame = message.header().frame_id();
  const std::string fault = frame != map_frame_
                                ? fmt::format("it is in frame '{}', not in '{}'", frame, map_frame_)
                                : fault_of(message.pose().pose());
  if (!fault.empty()) {
    initial_pose_remark_ = "ignored: " + fault;
    log_.error("initialpose {}", initial_pose_remark_);
    return;
  }
  const Pose2 X_MB = from_pose(normalised(message.pose().pose()));
  initial_pose_remark_ = text(X_MB);
  if (looks_for_place_) {
    search_.reset();
    given_ = X_MB;
    return;
  }
  if (!newest_) {  // the map begins there
    X_MW_ = X_MB;
    painter_ = std::make_unique<MapPainter>(options_.resolution, X_MW_);
    return;
  }
  const SearchWindow window = window_of(planar_covariance(message.pose().covariance()));
  const auto place = place_near(*slam_, newest_->points, inverse(X_MW_) * X_MB, window);
  if (!place) {
    initial_pose_remark_ += ": the scan does not fit the map there, the pose was kept";
    log_.warn("initialpose {}", initial_pose_remark_);
    return;
  }
  begin_at(*place);
  take_in(*newest_, newest_X_OB_);
}

std::string SlamComponent::doubt() const {
  if (given_ || given_X_MO_)
    return given_ ? "waits for a scan" : "the scan does not fit at the pose that was given";
  if (!search_) return "waits for scans and odometry";
  switch (search_->doubt()) {
    case PlaceSearch::Doubt::nothing_fits:
      return "nothing fits yet";
    case PlaceSearch::Doubt::several_fit:
      return "several places fit: drive on";
    case PlaceSearch::Doubt::one_direction_unseen:
      return "along one direction it could be anywhere: drive on";
    case PlaceSearch::Doubt::none:
      break;
  }
  return "searching";
}

}  // namespace bw::slam
