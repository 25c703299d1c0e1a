// `bandwagon view`: the page on a recording, on a robot that serves it, or on whatever ROS 2 system is on the
// domain.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "components/program/drive_page/drive_page.hpp"
#include "components/viewer/adaptor/page_server.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string what;
  std::string html;
  web::ServerOptions server;
  bool open = false;
};

/// A page of our own folder that leads to the address: on a command line every user of the machine could read
/// its token.
std::string page_that_leads_to(const std::string& address) {
  static const TemporaryFolder folder;  // as long as the program: browsers take their time
  const fs::path page = folder.path() / "open.html";
  write_file_atomically(
      page, fmt::format("<!doctype html><meta http-equiv=\"refresh\" content=\"0; url={}\">\n", address));
  return page.string();
}

/// Asks the desktop to show it; who has none opens it by hand.
void open_browser(const std::string& address) {
  std::string program = "xdg-open";
  std::string argument = address.find("?token=") == std::string::npos ? address : page_that_leads_to(address);
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  int status = 0;
  const bool is_started = posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) == 0;
  if (!is_started || waitpid(child, &status, 0) != child || status != 0)
    std::cerr << "no browser was opened (xdg-open); the address is " << address << "\n";
}

void tell(const ViewOptions& options, const std::string& words, const std::string& address) {
  std::cout << words << std::endl;
  if (options.open) open_browser(address);
}

void wait_for_interrupt() {
  cli::catch_interrupts();
  while (!cli::interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

/// The one recording in a folder, or the file itself.
fs::path recording_of(const fs::path& bag) {
  if (!fs::is_directory(bag)) return bag;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(bag)) {
    if (entry.path().extension() == ".mcap" || entry.path().extension() == ".db3")
      files.push_back(entry.path());
  }
  if (files.size() == 1) return files.front();
  throw std::runtime_error(fmt::format("{}: a folder with {} recordings; name one of its .mcap files",
                                       bag.string(), files.size()));
}

/// As a browser takes it in a query.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("-._~").find(c) != std::string_view::npos;
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

int view_bag(const ViewOptions& options) {
  const fs::path file = recording_of(fs::absolute(options.what));
  if (file.extension() != ".mcap") {
    throw std::runtime_error(
        fmt::format("{}: the page shows MCAP; `bandwagon bag convert {} OUT.mcap` makes one of it",
                    options.what, options.what));
  }
  web::ServerOptions server = options.server;
  server.bag_folder = file.parent_path().string();
  const viewer::RecordingServer page(server, Logger());
  const std::string address = page.address() + "?bag=" + escaped(file.filename().string());
  tell(options, viewer::invitation(address), address);
  wait_for_interrupt();
  return 0;
}

/// http://robot:8765/, however it was written; nothing for what is no address.
std::optional<std::string> address_of(const std::string& text) {
  static const std::regex kAddress(R"((https?://)?([A-Za-z0-9.-]+|\[[0-9a-fA-F:.]+\])(:[0-9]{1,5})?/?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, kAddress)) return std::nullopt;
  const bool is_named = parts[1].matched || parts[3].matched || parts[2] == "localhost";
  if (!is_named) return std::nullopt;
  const std::string scheme = parts[1].matched ? parts[1].str() : "http://";
  const std::string port = parts[3].matched ? parts[3].str() : parts[1].matched ? "" : ":8765";
  return scheme + parts[2].str() + port + "/";
}

int view_domain(const ViewOptions& options) {
  const viewer::PageServer page(
      options.server,
      {.network = dds::Network::from_environment(dds::Transport::localhost),
       .node = "bandwagon_view",  // /viewer is the node of a graph's own
       .metadata = {{"clock", "wall"}, {"accept_inputs", "true"}, {"version", program_version()}}},
      Logger());
  tell(options, viewer::invitation(page.address()), page.address());
  wait_for_interrupt();
  return 0;
}

/// `view BAG --html FILE`: the page and the recording in one file, nothing is served.
int write_page(const ViewOptions& options) {
  require_page("--html " + options.html);
  if (options.what.empty())
    throw std::runtime_error("--html " + options.html + " is made of a recording; name it");
  write_drive_page(options.what, fs::path(options.what).stem().string(), options.html);
  return 0;
}

int view(const ViewOptions& options) {
  if (!options.html.empty()) return write_page(options);
  if (options.what.empty()) return view_domain(options);
  if (fs::exists(options.what)) return view_bag(options);
  const std::optional<std::string> address = address_of(options.what);
  if (!address)
    throw std::runtime_error(
        options.what + ": neither a recording nor an address such as http://127.0.0.1:8765 or robot:8765");
  tell(options, "Page: " + *address, *address);
  return 0;
}

void add_view(cli::Verb verb) {
  auto options = std::make_shared<ViewOptions>();
  web::ServerOptions& server = options->server;
  verb.option(
      "WHAT", options->what,
      "An .mcap file or its folder, or http://HOST:PORT of a robot; without it what is on the domain");
  verb.option("--html", options->html,
              "Writes one page here that plays the recording, and serves nothing: a file to pass on");
  verb.flag("--open", options->open, "Opens a browser (xdg-open)");
  verb.option("--port", server.port, "0: any free one; the next free one where it is taken").within(0, 65535);
  verb.option("--bags", server.bag_folder, "Folder of recordings that the page may open");
  verb.option("--listen", server.address, "Address for others than this machine; needs --token-file");
  verb.option("--token-file", server.token_file, "File with the token that the page asks for");
  verb.option("--allow-origin", server.allow_origins, "A page of elsewhere that may connect").one_each_time();
  verb.flag("--allow-commands", server.allow_commands, "With --listen: others may command, one at a time");
  verb.run([options] { return view(*options); });
}

}  // namespace

BW_VERB(look, "view", "The page on a recording, a robot, or any ROS 2 system of the domain", add_view)

}  // namespace bw
