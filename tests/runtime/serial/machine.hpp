// A made-up sysfs, laid out as Linux lays out a USB adapter: class/tty/ttyUSB0 ->
// .../usb1/1-1/1-1:1.0/ttyUSB0/tty/ttyUSB0.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/serial/system_folders.hpp"
#include "tests/folder.hpp"

namespace bw::test {

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

}  // namespace bw::test
