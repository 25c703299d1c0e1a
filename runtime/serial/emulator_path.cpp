#include "runtime/serial/emulator_path.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace bw {

std::filesystem::path emulator_path(const std::string& name, int domain) {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime != '\0' && access(runtime, W_OK) == 0)
    return std::filesystem::path(runtime) / fmt::format("bandwagon-emulator-{}-{}", domain, name);
  return std::filesystem::temp_directory_path() /
         fmt::format("bandwagon-emulator-{}-{}-{}", geteuid(), domain, name);
}

}  // namespace bw
