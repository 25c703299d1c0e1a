// Experiment E7 (protocols.md 8.7): the EKF on logs of real robots. Every log is run with the same
// parameters.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/localization_replay.hpp"

namespace bw {

inline constexpr int kRealDataSeeds =
    10;  ///< of MRCLAM's receiver and compass; with fewer its order is not judged

/// All that the filter is told beside what the logs declare. The rest are its defaults.
struct RealDataParameters {
  ReplaySensors sensors;               ///< noise where a log declares none
  double position_walk = 0.22;         ///< [m/sqrt(m)]
  double heading_offset_sigma = 3.15;  ///< of a compass whose zero points anywhere [rad]
};

struct RealDataRow {
  std::string log;
  std::string task;
  std::string sensors;
  std::string reference;      ///< mean error [m] of an earlier study on the same data; empty: none
  double mean = 0.0;          ///< of the position [m], over the seeds
  double rms = 0.0;           ///< the same
  double largest = 0.0;       ///< of all seeds
  std::size_t count = 0;      ///< positions compared, in one run
  double first_pose = 0.0;    ///< [s] of the log; of the first seed
  std::vector<Vector2> path;  ///< estimates at the positions compared, first seed
};

/// How the figures depend on the one parameter that has no declared value.
struct WalkRow {
  double position_walk = 0.0;
  double husky_half = 0.0;    ///< wheels, gyro, receiver; every second fix held out: mean [m]
  double husky_outage = 0.0;  ///< the same, outage
  double mrclam_gps = 0.0;
  double mrclam_all = 0.0;
  double labyrinth = 0.0;  ///< wheels and ranges with gate
};

struct RealDataPicture {
  std::string title;
  struct Path {
    std::string label;
    std::vector<Vector2> points;
  };
  std::vector<Path> paths;
};

/// One of the logs, and what is known of where it comes from.
struct NamedLog {
  std::string name;
  std::string source;
  std::string licence;
  RecordedDrive drive;
};

struct RealDataLogs {
  NamedLog husky;
  NamedLog mrclam;
  NamedLog labyrinth;
};

struct RealDataResults {
  std::vector<NamedLog> logs;  ///< without their drives
  RealDataParameters parameters;
  int seeds = 0;  ///< of the synthetic receiver and compass
  std::vector<RealDataRow> rows;
  std::vector<WalkRow> walks;
  std::vector<RealDataPicture> pictures;
};

/// Husky: three sources of heading, three ways of holding fixes out; scored against those held out.
std::vector<RealDataRow> run_husky(const RecordedDrive& log, const RealDataParameters& parameters);

/// MRCLAM: wheels, + receiver, + compass, + both, in this order; scored against motion capture.
std::vector<RealDataRow> run_mrclam(const RecordedDrive& log, const RealDataParameters& parameters,
                                    int seeds);

/// Labyrinth: wheels, + ranges without and with gate, in this order, from the first pose that ranges give.
std::vector<RealDataRow> run_labyrinth(const RecordedDrive& log, const RealDataParameters& parameters);

RealDataResults run_real_data(const RealDataLogs& logs, int seeds, bool with_walks);

/// Half held out < 1.3 m, outage < 4 m (Husky with gyro), and the ordering of the thesis (MRCLAM).
std::vector<Criterion> real_data_criteria(const RealDataResults& results);

}  // namespace bw
