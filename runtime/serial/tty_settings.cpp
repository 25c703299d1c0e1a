#include "runtime/serial/tty_settings.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

// The kernel's own termios2 knows every speed; it cannot stand beside <termios.h>.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <fmt/format.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace bw {

std::string set_raw_line(int descriptor, std::int64_t baud) {
  termios2 line{};
  if (ioctl(descriptor, TCGETS2, &line) != 0) return "is not a serial line";
  line.c_iflag = IGNBRK | IGNPAR;
  line.c_oflag = 0;
  line.c_lflag = 0;
  // Without HUPCL the control lines stay as they were set when the port is closed: DTR holds the motor of
  // some lasers.
  line.c_cflag = CS8 | CREAD | CLOCAL | BOTHER;
  line.c_ispeed = line.c_ospeed = static_cast<speed_t>(baud);
  // A read finds nothing: EAGAIN. Zero bytes are then the end of the line, and nothing else.
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  if (ioctl(descriptor, TCSETS2, &line) != 0)
    return fmt::format("refuses {} bit/s, 8N1: {}", baud, std::strerror(errno));
  termios2 made{};
  if (ioctl(descriptor, TCGETS2, &made) != 0) return "is not a serial line any more";
  // A receiver samples the last of ten bits half a bit late at 5 %; both ends err.
  if (std::abs(static_cast<double>(made.c_ospeed) / static_cast<double>(baud) - 1.0) > 0.025)
    return fmt::format("cannot make {} bit/s: the nearest it has is {}", baud, made.c_ospeed);
  ioctl(descriptor, TCFLSH, TCIOFLUSH);  // what came before was for somebody else
  return {};
}

void set_low_latency(int descriptor) {
  serial_struct port{};
  if (ioctl(descriptor, TIOCGSERIAL, &port) != 0) return;
  port.flags |= static_cast<int>(ASYNC_LOW_LATENCY);
  ioctl(descriptor, TIOCSSERIAL, &port);
  // Apart, because only root may.
  port.closing_wait = 65535;  // none
  ioctl(descriptor, TIOCSSERIAL, &port);
}

bool set_dtr_line(int descriptor, bool is_set) {
  int lines = TIOCM_DTR;
  return ioctl(descriptor, is_set ? TIOCMBIS : TIOCMBIC, &lines) == 0;
}

void drain_and_close(int descriptor) {
  int waiting = 0;
  for (int i = 0; i < 100 && ioctl(descriptor, TIOCOUTQ, &waiting) == 0 && waiting > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (waiting > 0) ioctl(descriptor, TCFLSH, TCIOFLUSH);
  close(descriptor);
}

}  // namespace bw
