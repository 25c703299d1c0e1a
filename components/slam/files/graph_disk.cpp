#include "components/slam/files/graph_disk.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "runtime/atomic_file.hpp"

namespace bw::slam {

SavedGraph read_graph_file(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("cannot read " + path.string() + ": " + why);
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) refuse(error.message());
  if (!std::filesystem::is_regular_file(status)) refuse("it is no file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(std::strerror(errno));
  std::string bytes(std::filesystem::file_size(path), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));  // it may have been cut meanwhile
  GraphReading reading = read_graph(bytes);
  if (!reading.graph) refuse(reading.fault);
  return std::move(*reading.graph);
}

void write_graph_file(const std::filesystem::path& path, const SavedGraph& graph) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("cannot write " + path.string() + ": there is no folder " + folder.string());
  const std::string bytes = graph_bytes(graph);
  if (const GraphReading reading = read_graph(bytes); !reading.graph)
    throw std::runtime_error("cannot write " + path.string() +
                             ": it could not be read again: " + reading.fault);
  write_file_atomically(path, bytes);
}

}  // namespace bw::slam
