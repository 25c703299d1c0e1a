// Serial devices: which there are, who may open them, who has them open; and whether a graph's own can be
// had.
#pragma once

#include <string>
#include <vector>

#include "runtime/cli/doctor_report.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/serial/port_options.hpp"
#include "runtime/serial/system_folders.hpp"

namespace bw::cli {

/// Opens none of them.
void check_serial_devices(DoctorReport& report, const SystemFolders& folders = {});

struct GraphPort {
  std::string section;  ///< robot.base
  PortOptions options;
};

/// Of the devices in its shared sections (robot.base, robot.laser): each that has a `port`, but for emulated
/// ones, those whose driver is `none` or `simulated`, and those whose component (laser) is not enabled.
std::vector<GraphPort> ports_of(const Graph& graph);

/// Opens each as a driver would, and closes it again. Nothing is sent.
void check_ports(DoctorReport& report, const std::vector<GraphPort>& ports,
                 const SystemFolders& folders = {});

}  // namespace bw::cli
