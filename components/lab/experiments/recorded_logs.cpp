#include "components/lab/experiments/recorded_logs.hpp"

#include <utility>

#include "components/recordings/files/imported_drive.hpp"
#include "runtime/graph/config_file.hpp"

namespace bw {

RealDataLogs read_real_data(const std::filesystem::path& data) {
  const auto read = [&](const char* folder, const char* columns) -> NamedLog {
    BagDrive log = import_drive(config_file("imports", columns), {data / folder});
    return {log.log.name, log.log.source, log.log.licence, std::move(log.drive)};
  };
  return {.husky = read("husky_odom_imu_gps", "husky"),
          .mrclam = read("mrclam6_robot1", "mrclam"),
          .labyrinth = read("tuc_labyrinth_uwb", "labyrinth")};
}

}  // namespace bw
