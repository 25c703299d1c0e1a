#include <sstream>

#include "runtime/cli/doctor_devices.hpp"
#include "tests/runtime/serial/cable.hpp"
#include "tests/runtime/serial/machine.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

struct Doctor {
  std::ostringstream out;
  cli::DoctorReport report{out};
  std::string says() const { return out.str(); }
};

TEST(Doctor, SaysThatNothingIsPluggedIn) {
  Machine machine;
  Doctor doctor;
  check_serial_devices(doctor.report, machine.folders);
  EXPECT_EQ(doctor.says(), "ok    no serial device is plugged in\n");
  EXPECT_EQ(doctor.report.status(), 0);
}

TEST(Doctor, NamesEachDeviceAsARobotFileMayNameIt) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "kobuki_AH02B8FZ");
  Doctor doctor;
  check_serial_devices(doctor.report, machine.folders);
  EXPECT_THAT(doctor.says(), HasSubstr("FT232R USB UART, driver ftdi_sio, port: usb:kobuki_AH02B8FZ"));
  EXPECT_THAT(doctor.says(), HasSubstr("by-id/usb-FTDI_kobuki_AH02B8FZ: you may open it"));
  EXPECT_THAT(doctor.says(), HasSubstr("warn  " + (machine.folders.dev / "ttyUSB0").string() +
                                       " holds bytes back for 16 ms"));
}

TEST(Doctor, SaysWhoHasADeviceOpen) {
  Machine machine;
  PseudoTerminal device(machine.folder / "cable");
  device.update(now());
  SerialPort host({.port = (machine.folder / "cable").string()});
  ASSERT_TRUE(opens(host));
  machine.add_line("ttyACM0", machine.folders.sys / "devices" / "x");
  fs::remove(machine.folders.dev / "ttyACM0");
  fs::create_symlink(fs::canonical(machine.folder / "cable"), machine.folders.dev / "ttyACM0");
  Doctor doctor;
  check_serial_devices(doctor.report,
                       {.dev = machine.folders.dev, .proc = "/proc", .sys = machine.folders.sys});
  EXPECT_THAT(doctor.says(), HasSubstr("in use by process " + std::to_string(getpid())));
}

Graph graph_with(const Folder& folder, const std::string& robot, const std::string& components) {
  std::ofstream(folder / "graph.yaml") << "ros_distro: jazzy\nrobot:\n"
                                       << robot << "components:\n"
                                       << components;
  return load_graph(folder / "graph.yaml");
}

TEST(DoctorOfAGraph, LooksAtThePortsThatItsDriversWouldOpen) {
  Folder folder;
  const Graph graph = graph_with(folder,
                                 "  base: {driver: kobuki, port: /dev/kobuki}\n"
                                 "  laser: {driver: rplidar, port: usb:0001, baud: 256000, frame: laser}\n"
                                 "  other: {driver: none, port: /dev/nothing}\n",
                                 "  robot_base: {}\n  laser: {}\n");
  const auto ports = cli::ports_of(graph);
  ASSERT_EQ(ports.size(), 2U);
  EXPECT_EQ(ports[0].section, "robot.base");
  EXPECT_EQ(ports[0].options.port, "/dev/kobuki");
  EXPECT_EQ(ports[0].options.baud, 115'200);
  EXPECT_EQ(ports[1].options.port, "usb:0001");
  EXPECT_EQ(ports[1].options.baud, 256'000);
}

TEST(DoctorOfAGraph, LeavesOutEmulatorsSimulatedBasesAndDevicesThatAreOff) {
  Folder folder;
  const Graph graph = graph_with(folder,
                                 "  base: {driver: kobuki, port: emulator}\n"
                                 "  laser: {driver: rplidar, port: /dev/rplidar}\n"
                                 "  other: {driver: simulated, port: /dev/kobuki}\n",
                                 "  laser: {enabled: false}\n");
  EXPECT_TRUE(cli::ports_of(graph).empty());
}

TEST(DoctorOfAGraph, OpensEachAndSaysWhatToDo) {
  Cable cable;
  cable.device.update(now());
  Doctor doctor;
  check_ports(doctor.report, {{"robot.base", {.port = (cable.folder / "cable").string()}}});
  EXPECT_THAT(doctor.says(), HasSubstr("at 115200 bit/s can be opened"));
  EXPECT_EQ(doctor.report.status(), 0);
  check_ports(doctor.report, {{"robot.laser", {.port = (cable.folder / "laser").string()}}});
  EXPECT_THAT(doctor.says(), HasSubstr("laser at 115200 bit/s: no such device: is it plugged in"));
  EXPECT_EQ(doctor.report.status(), 1);
}

}  // namespace
}  // namespace bw::test
