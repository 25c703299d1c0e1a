#include "components/lab/experiments/recorded_logs.hpp"

#include <utility>

#include "components/recordings/files/imported_drive.hpp"

namespace bw {

RealDataLogs read_real_data(const std::filesystem::path& data, const std::filesystem::path& imports) {
  const auto read = [&](const char* folder, const char* columns) -> NamedLog {
    BagDrive log = import_drive(imports / columns, {data / folder});
    return {log.log.name, log.log.source, log.log.licence, std::move(log.drive)};
  };
  return {.husky = read("husky_odom_imu_gps", "husky.yaml"),
          .mrclam = read("mrclam6_robot1", "mrclam.yaml"),
          .labyrinth = read("tuc_labyrinth_uwb", "labyrinth.yaml")};
}

}  // namespace bw
