#include "components/program/bag_description.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "runtime/build_identity.hpp"

namespace bw {
namespace {

constexpr const char* kYaml = "application/yaml";

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string parameters_of(const Host& host) {
  std::string text;
  for (const auto& [name, report] : host.parameters()) {
    text += name + ":\n";
    std::istringstream lines(report.yaml);
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  }
  return text;
}

}  // namespace

bag::BagDescription describe(const Host& host, const HostOptions& options) {
  const std::filesystem::path& graph = host.graph().path;
  constexpr const char* kClocks[] = {"wall", "lockstep", "topic"};
  bag::BagDescription description{.attachments = {{"graph.yaml", kYaml, content_of(graph)},
                                                  {"parameters.yaml", kYaml, parameters_of(host)}},
                                  .metadata = {{"bandwagon",
                                                {{"version", program_version()},
                                                 {"revision", source_revision()},
                                                 {"build_id", build_id()},
                                                 {"cpu", cpu_type()},
                                                 {"host", host_name()},
                                                 {"clock", kClocks[static_cast<int>(options.clock)]},
                                                 {"seed", std::to_string(options.seed)},
                                                 {"process", options.only_process},
                                                 {"graph", graph.string()}}}}};
  for (const auto& [name, section] : host.graph().shared) {
    const std::filesystem::path file = section.where.file;
    std::error_code none;
    if (file.empty() || !std::filesystem::is_regular_file(file, none) || file == graph) continue;
    description.attachments.push_back({name + ".yaml", kYaml, content_of(file)});
  }
  return description;
}

std::string ros_distro_of(const Graph& graph) {
  const RosDistro distro = graph.settings.ros_distro;
  return distro == RosDistro::automatic ? bag::default_ros_distro() : std::string(text_of(distro));
}

}  // namespace bw
