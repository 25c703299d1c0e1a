// The three bases that drive through buildings: what their robot files say, and how their wheels err.
#pragma once

#include "components/model/robot.hpp"
#include "components/world/drive_model.hpp"

namespace bw::buildings {

enum class DrivenBase { kobuki, qbot2e, eddie };
const char* to_text(DrivenBase base);

/// Wheels, encoders, radius and limits of config/robots/.
Robot robot_of(DrivenBase base);

/// Wheels as they come: the errors of config/graphs/hallway.yaml, with which emulated bases are driven, and
/// rims that accelerate no faster than the base's limits say. 0.4 % between the wheels bend a Kobuki's path
/// by a degree each metre: nothing measures its turns but the wheels. A QBot 2e moreover stands on the Kobuki
/// driver's 0.230 m where its file believes Quanser's 0.235 m.
DriveOptions wheels_of(DrivenBase base);

/// The same after `bandwagon calibrate`: systematic errors as large as a calibration may leave them (0.1 %
/// between the wheels, 0.3 % of the separation, 0.2 % of the scale).
DriveOptions calibrated_wheels_of(DrivenBase base);

/// Wheels that do not err at all.
DriveOptions perfect_wheels_of(DrivenBase base);

}  // namespace bw::buildings
