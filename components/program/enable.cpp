// `bandwagon enable`: a robot that starts by itself. Writes its robot file, its options and systemd's link, and
// says what it did.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/atomic_file.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/config_file.hpp"
#include "runtime/host/host.hpp"
#include "runtime/parameters/own_program.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnit = "bandwagon@.service";

struct EnableOptions {
  std::string robot;
  fs::path map;
  fs::path root = "/";
};

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What systemd's names and ours both allow.
std::string name_of(const fs::path& robot_file) {
  std::string name = robot_file.stem().string();
  const bool is_plain = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!is_plain)
    throw std::runtime_error(fmt::format(
        "{}: a unit's name has letters, digits, _ and - alone; rename the file", robot_file.string()));
  return name;
}

fs::path below(const fs::path& root, const fs::path& path) { return root / path.relative_path(); }

/// The service has no access to people's folders, and systemd takes options apart at blanks. Whether a map of
/// another machine's will be there is not known here.
fs::path readable_map(const fs::path& map, const fs::path& root) {
  const fs::path path = fs::canonical(map);
  if (path.string().find_first_of(" \t\n\"'\\$%") != std::string::npos)
    throw std::runtime_error(path.string() +
                             ": blanks, quotes, \\, $ and % are no part of a service's options; rename it");
  if (root != "/") return path;
  for (const char* hidden : {"/home", "/root", "/tmp"}) {
    if (path.string().starts_with(std::string(hidden) + "/"))
      throw std::runtime_error(fmt::format(
          "{}: the service cannot read below {}; copy the map, with its picture, to /etc/bandwagon/maps",
          path.string(), hidden));
  }
  return path;
}

/// The map, and the keep-out zones that were saved beside it.
std::vector<std::string> map_settings(const EnableOptions& options) {
  if (options.map.empty()) return {};
  const fs::path map = readable_map(options.map, options.root);
  const fs::path zones = map.parent_path() / (map.stem().string() + "_keepout.yaml");
  std::vector<std::string> settings = {"map_server.map=" + map.string()};
  if (fs::exists(zones)) settings.push_back("keepout_filter_mask_server.map=" + zones.string());
  return settings;
}

void refuse_without_driver(const ConfigNode& robot, const fs::path& file) {
  const ConfigNode* driver = find_dotted(robot, "base.driver");
  if (driver == nullptr || driver->scalar == "simulated" || driver->scalar == "none")
    throw std::runtime_error(
        fmt::format("{}: base.driver names no driver of a base: this robot drives in a simulated world alone",
                    file.string()));
}

void write_robot(const fs::path& from, const fs::path& to) {
  if (fs::exists(to) && fs::equivalent(from, to)) {
    std::cout << "Robot file:  " << to.string() << ", as it is\n";
    return;
  }
  const std::string content = content_of(from);
  if (fs::exists(to) && content_of(to) != content)
    throw std::runtime_error(
        fmt::format("{} exists already and differs from {}: change that one, or remove it first", to.string(),
                    from.string()));
  write_file_atomically(to, content);
  fs::permissions(
      to, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);
  std::cout << "Robot file:  " << to.string() << "\n";
}

int enable(const EnableOptions& options) {
  const fs::path program = own_program().parent_path();
  const fs::path unit = fs::weakly_canonical(program / "../lib/systemd/system" / kUnit);
  if (!fs::exists(unit))
    throw std::runtime_error(fmt::format(
        "{} is missing: a program that is installed has it (the Debian package, or cmake --install)",
        unit.string()));
  const fs::path robot = config_file("robots", options.robot, {});
  const std::string name = name_of(robot);
  // Refused now and not at the next boot.
  std::vector<std::string> settings = {"robot=" + fs::absolute(robot).string()};
  const std::vector<std::string> maps = map_settings(options);
  settings.insert(settings.end(), maps.begin(), maps.end());
  const Graph graph = load_graph("robot", settings);
  refuse_without_driver(graph.shared.at("robot"), robot);
  const Host checked(graph, {});

  write_robot(robot, below(options.root, "/etc/bandwagon/robots/" + name + ".yaml"));
  const fs::path options_file = below(options.root, "/etc/bandwagon/" + name + ".options");
  if (!options.map.empty()) {
    write_file_atomically(
        options_file,
        fmt::format("# Options of `bandwagon run` for this robot.\nBANDWAGON_OPTIONS=--set {}\n",
                    fmt::join(maps, " --set ")));
    std::cout << "Options:     " << options_file.string() << fmt::format(" ({})\n", fmt::join(maps, ", "));
  } else if (!fs::exists(options_file)) {
    std::cout << "Options:     none; BANDWAGON_OPTIONS=... of `bandwagon run` go to " << options_file.string()
              << "\n"
              << "             There is no map: drive by hand; goals need --map MAP.yaml and a first pose.\n";
  }
  const fs::path link =
      below(options.root, "/etc/systemd/system/multi-user.target.wants/bandwagon@" + name + ".service");
  fs::create_directories(link.parent_path());
  fs::remove(link);
  fs::create_symlink(unit, link);
  std::cout
      << "At boot:     " << link.string() << "\n\n"
      << fmt::format(
             "It starts with the machine from now on. By hand:\n"
             "  sudo systemctl daemon-reload && sudo systemctl start bandwagon@{0}   # now\n"
             "  systemctl status bandwagon@{0}                                       # its state in words\n"
             "  journalctl -u bandwagon@{0}                                          # its log, with the page's address\n"
             "  sudo systemctl disable --now bandwagon@{0}                           # brings it to rest, and no longer at boot\n",
             name);
  return 0;
}

void add_enable(cli::Verb verb) {
  auto options = std::make_shared<EnableOptions>();
  verb.option("ROBOT", options->robot, "Robot file, or the name of one (`bandwagon robots`)").required();
  verb.option("--map", options->map, "Map in map_server's form, for goals").existing_file();
  verb.option("--root", options->root, "Writes below this folder, for an image of another machine")
      .existing_folder();
  verb.run([options] { return enable(*options); });
}

BW_VERB(drive, "enable", "Sets a robot up to start with this machine, as a service of systemd", add_enable)

}  // namespace
}  // namespace bw
