#include <cstdio>
#include <filesystem>
#include <memory>

#include "components/lab/figures/figures.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

int draw_all(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const figures::Figure& figure : figures::all()) {
    const std::filesystem::path file = folder / (std::string(figure.name) + ".svg");
    write_file_atomically(file, figure.draw());
    std::printf("%s: %s\n", file.c_str(), std::string(figure.about).c_str());
  }
  return 0;
}

void add_figures(cli::Verb verb) {
  auto folder = std::make_shared<std::filesystem::path>("docs/figures");
  verb.option("--out", *folder, "Folder for the drawings");
  verb.run([folder] { return draw_all(*folder); });
}

}  // namespace

BW_VERB(measure, "figures", "Draws the figures of the theory pages anew", add_figures)

}  // namespace bw
