// On a made-up sysfs, laid out as Linux lays out a USB adapter: class/tty/ttyUSB0 -> .../usb1/1-1/1-1:1.0/ttyUSB0/tty/ttyUSB0.
#include "runtime/serial/serial_devices.hpp"

#include <fstream>

#include "tests/folder.hpp"

namespace bw::test {
namespace {

namespace fs = std::filesystem;

struct Machine {
  Folder folder;
  SystemFolders folders{.dev = folder / "dev", .proc = folder / "proc", .sys = folder / "sys"};

  Machine() {
    fs::create_directories(folders.sys / "class" / "tty");
    fs::create_directories(folders.dev / "serial" / "by-id");
  }
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text << "\n";
  }
  void add_line(const std::string& name, const fs::path& device) const {
    fs::create_directories(device / "tty" / name);
    fs::create_directory_symlink(device, device / "tty" / name / "device");
    fs::create_directory_symlink(device / "tty" / name, folders.sys / "class" / "tty" / name);
    write(folders.dev / name, "");
  }
  /// An FTDI adapter at a USB port.
  void add_ftdi(const std::string& name, const std::string& port, const std::string& serial) const {
    const fs::path usb = folders.sys / "devices" / "pci0000:00" / "usb1" / port;
    write(usb / "idVendor", "0403");
    write(usb / "product", "FT232R USB UART");
    if (!serial.empty()) write(usb / "serial", serial);
    const fs::path line = usb / (port + ":1.0") / name;
    add_line(name, line);
    write(line / "latency_timer", "16");
    fs::create_directories(folders.sys / "bus" / "drivers" / "ftdi_sio");
    fs::create_directory_symlink(folders.sys / "bus" / "drivers" / "ftdi_sio", line / "driver");
    // Of two with one name, udev links the last.
    const fs::path by_id = folders.dev / "serial" / "by-id" / ("usb-FTDI_" + serial);
    fs::remove(by_id);
    if (!serial.empty()) fs::create_symlink(folders.dev / name, by_id);
  }
};

TEST(SerialDevices, TellsWhatSysfsSays) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "kobuki_AH02B8FZ");
  const auto devices = serial_devices(machine.folders);
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].device, machine.folders.dev / "ttyUSB0");
  EXPECT_EQ(devices[0].by_id, machine.folders.dev / "serial" / "by-id" / "usb-FTDI_kobuki_AH02B8FZ");
  EXPECT_EQ(devices[0].driver, "ftdi_sio");
  EXPECT_EQ(devices[0].product, "FT232R USB UART");
  EXPECT_EQ(devices[0].usb_serial, "kobuki_AH02B8FZ");
  EXPECT_EQ(devices[0].latency_timer, 16);
}

TEST(SerialDevices, LeavesOutReservedPortsAndTerminals) {
  Machine machine;
  machine.add_line("ttyS0", machine.folders.sys / "devices" / "platform" / "serial8250");
  machine.write(machine.folders.sys / "class" / "tty" / "ttyS0" / "type", "0");
  machine.add_line("ttyS1", machine.folders.sys / "devices" / "pnp0" / "00:01");
  machine.write(machine.folders.sys / "class" / "tty" / "ttyS1" / "type", "4");
  fs::create_directories(machine.folders.sys / "class" / "tty" / "tty7");
  const auto devices = serial_devices(machine.folders);
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].device.filename(), "ttyS1");
  EXPECT_EQ(devices[0].usb_serial, "");
  EXPECT_FALSE(devices[0].latency_timer.has_value());
}

TEST(FindPort, FollowsAUsbSerialNumberWhereverItIsPluggedIn) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "LASER");
  machine.add_ftdi("ttyUSB1", "1-2", "BASE");
  EXPECT_EQ(find_port("usb:BASE", machine.folders).device, machine.folders.dev / "ttyUSB1");
  EXPECT_EQ(find_port("usb:LASER", machine.folders).device, machine.folders.dev / "ttyUSB0");
  EXPECT_EQ(find_port("/dev/any", machine.folders).device, "/dev/any");
  EXPECT_THAT(find_port("usb:OTHER", machine.folders).fault, testing::HasSubstr("OTHER: plug it in"));
  EXPECT_THAT(find_port("usb:", machine.folders).fault, testing::HasSubstr("no USB adapter"));
}

TEST(FindPort, TwoOfANumberAreRefusedWithBothNames) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "0001");
  machine.add_ftdi("ttyUSB1", "1-2", "0001");
  const FoundPort found = find_port("usb:0001", machine.folders);
  EXPECT_TRUE(found.device.empty());
  EXPECT_THAT(found.fault, testing::AllOf(testing::HasSubstr("ttyUSB0"), testing::HasSubstr("ttyUSB1"),
                                          testing::HasSubstr("name one by its path")));
}

// The chip CP2102 of many lasers has 0001, and cheap adapters have none: those are no number.
TEST(FindPort, ADeviceWithoutANumberIsNotFoundByAnEmptyOne) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "");
  EXPECT_FALSE(find_port("usb:", machine.folders).fault.empty());
}

}  // namespace
}  // namespace bw::test
