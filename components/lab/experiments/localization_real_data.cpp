#include "components/lab/experiments/localization_real_data.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "components/lab/experiments/range_start.hpp"
#include "components/localization/ekf/ekf.hpp"
#include "components/recordings/hold_out.hpp"
#include "components/recordings/synthetic_sensors.hpp"

namespace bw {
namespace {

using localization::Ekf;
using localization::EkfOptions;

constexpr localization::Geodetic kIndoorDatum{21.0, 105.8, 0.0};  // any position will do
constexpr double kStartHeadingSigma = 0.2;                        // [rad], as EkfOptions::initial

enum class Heading { gyro, compass, wheels };

EkfOptions ekf_options(const RealDataParameters& parameters) {
  EkfOptions options;
  options.motion.position_walk = parameters.position_walk;
  return options;
}

RealDataRow row_of(const ReplayResult& result) {
  const ReplayErrors errors = errors_of(result.points);
  RealDataRow row{.mean = errors.mean, .rms = errors.rms, .largest = errors.largest, .count = errors.count};
  if (result.first_pose) row.first_pose = result.first_pose->to_seconds();
  for (const ReplayPoint& point : result.points) row.path.push_back(point.position);
  return row;
}

RealDataRow husky_row(const RecordedDrive& log, const RealDataParameters& parameters, Heading heading,
                      const HoldOutOptions& rule) {
  RecordedDrive drive = log;
  const std::vector<FixSample> held_out = hold_out(drive, rule);
  ReplaySensors sensors = parameters.sensors;
  sensors.gyro = heading != Heading::wheels;
  sensors.compass = heading == Heading::compass;
  sensors.compass_after_start = true;
  EkfOptions options = ekf_options(parameters);
  options.bias.heading_offset = heading == Heading::compass;
  options.bias.heading_offset_sigma = parameters.heading_offset_sigma;
  Ekf ekf(options);
  RealDataRow row = row_of(replay(drive, sensors, fix_checkpoints(held_out, log.datum), ekf));
  row.log = "Husky";
  if (heading == Heading::wheels) row.sensors = "wheels, receiver";
  if (heading == Heading::gyro) row.sensors = "wheels, gyro, receiver";
  if (heading == Heading::compass) row.sensors = "wheels, gyro, compass with offset, receiver";
  return row;
}

RealDataRow mrclam_row(const RecordedDrive& log, const RealDataParameters& parameters, bool receiver,
                       bool compass, std::uint64_t seed) {
  RecordedDrive drive = log;
  add_synthetic_sensors(drive, {}, kIndoorDatum, seed);
  ReplaySensors sensors = parameters.sensors;
  sensors.receiver = receiver;
  sensors.compass = compass;
  const auto start = reference_at(drive, drive.odometry.front().time, Duration::seconds(1));
  if (!start || !start->heading) throw std::runtime_error("the reference does not begin before the wheels");
  Ekf ekf(ekf_options(parameters));
  ekf.start_at({start->position.x(), start->position.y(), *start->heading},
               1e-6 * Eigen::Matrix3d::Identity(), start->time);
  std::vector<Checkpoint> checkpoints = reference_checkpoints(drive);
  std::erase_if(checkpoints, [&](const Checkpoint& checkpoint) { return checkpoint.time < start->time; });
  RealDataRow row = row_of(replay(drive, sensors, checkpoints, ekf));
  row.first_pose = start->time.to_seconds();
  return row;
}

RealDataRow mean_row(const RecordedDrive& log, const RealDataParameters& parameters, bool receiver,
                     bool compass, int seeds) {
  RealDataRow mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    RealDataRow row = mrclam_row(log, parameters, receiver, compass, static_cast<std::uint64_t>(seed));
    if (seed == 1) std::swap(mean.path, row.path);
    mean.mean += row.mean / seeds;
    mean.rms += row.rms / seeds;
    mean.largest = std::max(mean.largest, row.largest);
    mean.count = row.count;
    mean.first_pose = row.first_pose;
  }
  return mean;
}

RealDataRow labyrinth_row(const RecordedDrive& log, const RealDataParameters& parameters, bool ranges,
                          bool gate) {
  const auto start = range_start(log, kStartHeadingSigma);
  if (!start) throw std::runtime_error("the ranges give no first pose");
  RecordedDrive drive = log;
  std::erase_if(drive.ranges, [&](const RangeSample& range) { return range.time <= start->time; });
  std::erase_if(drive.odometry, [&](const OdometrySample& sample) { return sample.time < start->time; });
  std::vector<Checkpoint> checkpoints = reference_checkpoints(drive);
  std::erase_if(checkpoints, [&](const Checkpoint& checkpoint) { return checkpoint.time < start->time; });
  ReplaySensors sensors = parameters.sensors;
  sensors.ranges = ranges;
  EkfOptions options = ekf_options(parameters);
  options.gate.enabled = gate;
  Ekf ekf(options);
  ekf.start_at(start->X_MB, start->covariance, start->time);
  RealDataRow row = row_of(replay(drive, sensors, checkpoints, ekf));
  row.first_pose = start->time.to_seconds();
  return row;
}

std::vector<Vector2> positions(const std::vector<Checkpoint>& checkpoints) {
  std::vector<Vector2> points;
  for (const Checkpoint& checkpoint : checkpoints) points.push_back(checkpoint.position);
  return points;
}

/// Fixes until shortly after the first pose, then none.
std::vector<Vector2> husky_without_receiver(const RecordedDrive& log, const RealDataParameters& parameters) {
  return husky_row(log, parameters, Heading::gyro, {.rule = HoldOutRule::outage, .from = 10.0, .to = 1e6})
      .path;
}

WalkRow walk_row(const RecordedDrive& husky, const RecordedDrive& mrclam, const RecordedDrive& labyrinth,
                 RealDataParameters parameters, double walk) {
  parameters.position_walk = walk;
  return {walk,
          husky_row(husky, parameters, Heading::gyro, {.rule = HoldOutRule::every_second}).mean,
          husky_row(husky, parameters, Heading::gyro, {.rule = HoldOutRule::outage}).mean,
          mean_row(mrclam, parameters, true, false, 1).mean,
          mean_row(mrclam, parameters, true, true, 1).mean,
          labyrinth_row(labyrinth, parameters, true, true).mean};
}

}  // namespace

std::vector<RealDataRow> run_husky(const RecordedDrive& log, const RealDataParameters& parameters) {
  struct Task {
    const char* name;
    HoldOutOptions rule;
    const char* reference[3];  ///< of each heading
  };
  const Task tasks[] = {
      {"every second fix held out", {.rule = HoldOutRule::every_second}, {"0.85 to 1.2", "", ""}},
      {"a fix only every 10 s", {.rule = HoldOutRule::sparse}, {"1.8", "", ""}},
      {"no fix from 150 s to 250 s", {.rule = HoldOutRule::outage}, {"2.4", "6.5", "9.4"}}};
  std::vector<RealDataRow> rows;
  for (const Task& task : tasks) {
    for (const Heading heading : {Heading::gyro, Heading::compass, Heading::wheels}) {
      rows.push_back(husky_row(log, parameters, heading, task.rule));
      rows.back().task = task.name;
      rows.back().reference = task.reference[static_cast<int>(heading)];
    }
  }
  return rows;
}

std::vector<RealDataRow> run_mrclam(const RecordedDrive& log, const RealDataParameters& parameters,
                                    int seeds) {
  const struct {
    const char* sensors;
    const char* reference;
    bool receiver, compass;
  } sets[] = {{"wheels", "1.98", false, false},
              {"wheels, receiver", "0.095", true, false},
              {"wheels, compass", "0.52", false, true},
              {"wheels, receiver, compass", "0.078", true, true}};
  std::vector<RealDataRow> rows;
  for (const auto& set : sets) {
    rows.push_back(mean_row(log, parameters, set.receiver, set.compass, seeds));
    rows.back().log = "MRCLAM 6, robot 1";
    rows.back().task = "fixes 1 Hz 0.2 m, headings 10 Hz 1 deg, made from the reference";
    rows.back().sensors = set.sensors;
    rows.back().reference = set.reference;
  }
  return rows;
}

std::vector<RealDataRow> run_labyrinth(const RecordedDrive& log, const RealDataParameters& parameters) {
  std::vector<RealDataRow> rows{labyrinth_row(log, parameters, false, true),
                                labyrinth_row(log, parameters, true, false),
                                labyrinth_row(log, parameters, true, true)};
  const char* const sensors[] = {"wheels", "wheels, ranges, no gate", "wheels, ranges, gate"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].log = "Labyrinth";
    rows[i].task = "first pose from ranges";
    rows[i].sensors = sensors[i];
  }
  return rows;
}

RealDataResults run_real_data(const RealDataLogs& logs, int seeds, bool with_walks) {
  RealDataResults results{.seeds = seeds};
  for (const NamedLog* log : {&logs.husky, &logs.mrclam, &logs.labyrinth})
    results.logs.push_back({log->name, log->source, log->licence, {}});
  const RealDataParameters& parameters = results.parameters;
  const RecordedDrive& husky = logs.husky.drive;
  const RecordedDrive& mrclam = logs.mrclam.drive;
  const RecordedDrive& labyrinth = logs.labyrinth.drive;
  const std::vector<RealDataRow> outdoors = run_husky(husky, parameters);
  const std::vector<RealDataRow> indoors = run_mrclam(mrclam, parameters, seeds);
  const std::vector<RealDataRow> maze = run_labyrinth(labyrinth, parameters);
  for (const auto* rows : {&outdoors, &indoors, &maze})
    results.rows.insert(results.rows.end(), rows->begin(), rows->end());
  results.pictures = {{"Husky: fixes, with every second of them, and without any after 10 s",
                       {{"fixes", positions(fix_checkpoints(husky.fixes, husky.datum))},
                        {"with receiver", outdoors[0].path},
                        {"without", husky_without_receiver(husky, parameters)}}},
                      {"MRCLAM: motion capture, all sensors, and wheels alone",
                       {{"reference", positions(reference_checkpoints(mrclam))},
                        {"all sensors", indoors[3].path},
                        {"wheels", indoors[0].path}}},
                      {"Labyrinth: reference, wheels and ranges, wheels alone",
                       {{"reference", positions(reference_checkpoints(labyrinth))},
                        {"wheels, ranges", maze[2].path},
                        {"wheels", maze[0].path}}}};
  if (!with_walks) return results;
  for (const double walk : {0.0, 0.07, 0.15, 0.22, 0.45})
    results.walks.push_back(walk_row(husky, mrclam, labyrinth, parameters, walk));
  return results;
}

std::vector<Criterion> real_data_criteria(const RealDataResults& results) {
  const auto mean = [&](std::string_view log, std::string_view task, std::string_view sensors) {
    for (const RealDataRow& row : results.rows) {
      const bool is_it = row.log.starts_with(log) && row.task.starts_with(task) && row.sensors == sensors;
      // A run without a single comparison has shown nothing.
      if (is_it) return row.count > 0 ? row.mean : std::numeric_limits<double>::infinity();
    }
    throw std::logic_error("no such row");
  };
  const double half = mean("Husky", "every", "wheels, gyro, receiver");
  const double outage = mean("Husky", "no fix", "wheels, gyro, receiver");
  const double wheels = mean("MRCLAM", "", "wheels");
  const double receiver = mean("MRCLAM", "", "wheels, receiver");
  const double compass = mean("MRCLAM", "", "wheels, compass");
  const double all = mean("MRCLAM", "", "wheels, receiver, compass");
  const auto of_mrclam = [&](const char* name, double ratio) {
    return over_seeds({name, "> 1", ratio, ratio > 1.0}, static_cast<std::size_t>(results.seeds),
                      kRealDataSeeds);
  };
  return {{"Husky, every second fix held out: mean error [m]", "< 1.3", half, half < 1.3},
          {"Husky, outage of 100 s with gyro: mean error [m]", "< 4", outage, outage < 4.0},
          of_mrclam("MRCLAM: wheels / wheels and receiver", wheels / receiver),
          of_mrclam("MRCLAM: wheels / wheels and compass", wheels / compass),
          of_mrclam("MRCLAM: wheels and receiver / all", receiver / all),
          of_mrclam("MRCLAM: wheels and compass / all", compass / all)};
}

}  // namespace bw
