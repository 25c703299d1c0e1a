#include "components/lab/experiments/project_file.hpp"

#include <stdexcept>

namespace bw {

std::filesystem::path project_file(const std::filesystem::path& path) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const std::filesystem::path& folder : {std::filesystem::path("."), program / "../share/bandwagon",
                                              program / "../../..", program / "../../../.."}) {
    if (std::filesystem::exists(folder / path)) return folder / path;
  }
  throw std::runtime_error(path.string() + " is not found: run this in the project's folder");
}

}  // namespace bw
