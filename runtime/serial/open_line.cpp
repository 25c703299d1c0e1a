#include "runtime/serial/open_line.hpp"

#include <cerrno>
#include <cstring>

#include <asm/ioctls.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/serial/port_holders.hpp"
#include "runtime/serial/serial_devices.hpp"
#include "runtime/serial/tty_settings.hpp"

namespace bw {
namespace {

std::string no_such_device(const SystemFolders& folders) {
  std::string there;
  for (const SerialDevice& device : serial_devices(folders))
    there += (there.empty() ? "" : ", ") + device.device.string();
  return "no such device: is it plugged in and switched on? There " +
         (there.empty() ? "is no serial device" : "are " + there);
}

std::string why_not_opened(int error, const std::string& device, const SystemFolders& folders) {
  if (error == ENOENT) return no_such_device(folders);
  if (error == EACCES || error == EPERM) {
    const std::string why = why_not_permitted(device);
    return why.empty() ? "permission denied" : why;
  }
  if (error == EBUSY) return "owned by somebody else: in use by a process of another user";
  if (error == ENXIO || error == EIO || error == ENODEV)
    return "the device does not answer: unplug it and plug it in again";
  return std::strerror(error);
}

/// Owns nobody else it? Returns who does in words.
std::string claim(int descriptor, const struct stat& status, const SystemFolders& folders) {
  const bool is_ours = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  const auto others = holders_of(status, descriptor, folders);
  if (!is_ours || !others.empty()) return "owned by somebody else: in use by " + in_words(others);
  // Shuts out who comes later and looks for no lock. Of a pseudo-terminal the mark would outlive this
  // process.
  if (!is_pseudo_terminal(status.st_rdev)) ioctl(descriptor, TIOCEXCL);
  return {};
}

std::string prepare(int descriptor, std::int64_t baud, const SystemFolders& folders) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return std::strerror(errno);
  if (!isatty(descriptor)) return "is not a serial line";
  if (std::string owner = claim(descriptor, status, folders); !owner.empty()) return owner;
  if (std::string fault = set_raw_line(descriptor, baud); !fault.empty()) return fault;
  set_low_latency(descriptor);
  return {};
}

}  // namespace

OpenedLine open_line(const PortOptions& options, const SystemFolders& folders) {
  const FoundPort found = find_port(options.port, folders);
  OpenedLine line{.descriptor = -1, .device = options.port, .fault = found.fault};
  if (!line.fault.empty()) return line;
  const std::string path = found.device.string();
  if (path != options.port) line.device = fmt::format("{} ({})", options.port, path);
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISCHR(status.st_mode)) {
    line.fault = S_ISDIR(status.st_mode) ? "is a folder, no serial line" : "is a file, no serial line";
    return line;
  }
  const int descriptor = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    line.fault = why_not_opened(errno, path, folders);
    return line;
  }
  line.fault = prepare(descriptor, options.baud, folders);
  if (line.fault.empty()) {
    line.descriptor = descriptor;
  } else {
    close(descriptor);
  }
  return line;
}

}  // namespace bw
