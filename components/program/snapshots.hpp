// The flight recorder of a drive, from the graph's section `snapshot` to what is said of it.
#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include "runtime/graph/snapshot_settings.hpp"
#include "runtime/host/host.hpp"
#include "runtime/recording/bag/flight_recorder.hpp"

namespace bw {

class Snapshots {
 public:
  Snapshots() : recorder_(std::make_shared<std::shared_ptr<bag::FlightRecorder>>()) {}

  /// For the log and the diagnostics, in real time only. It listens to /snapshot, std_msgs/String: whatever
  /// is written there is an event of that name. In a graph of several processes it tells the others there
  /// what happened in `process`; empty: there are no others. To be made before the host, which takes it.
  [[nodiscard]] std::unique_ptr<Component> make_reporter(const std::string& process) const;
  /// When the host has checked `graph`. Throws ConfigError for events that cannot be, std::runtime_error for
  /// a folder that cannot be written; makes no folder yet.
  [[nodiscard]] std::shared_ptr<SampleTap> open(const Graph& graph, const Host& host,
                                                const HostOptions& options, bag::BagDescription description);
  /// Ends a snapshot that is being written.
  void finish() { (*recorder_)->close(); }
  /// What the reporter has not told yet, which in lock-step is everything: one line each.
  [[nodiscard]] std::string untold() const;
  [[nodiscard]] nlohmann::json json() const;

 private:
  std::shared_ptr<std::shared_ptr<bag::FlightRecorder>> recorder_;  ///< empty until open()
  std::shared_ptr<std::size_t> told_ = std::make_shared<std::size_t>(0);
};

}  // namespace bw
