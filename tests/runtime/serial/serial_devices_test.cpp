#include "runtime/serial/serial_devices.hpp"

#include "tests/runtime/serial/machine.hpp"

namespace bw::test {
namespace {

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
