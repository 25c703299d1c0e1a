#include "components/program/page_options.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "runtime/parameters/overrides.hpp"

namespace bw {
namespace {

constexpr const char* kType = "viewer";

ConfigNode scalar(const std::string& text, bool is_text) {
  ConfigNode node;
  node.kind = ConfigNode::Kind::kScalar;
  node.scalar = text;
  node.quoted = is_text;
  node.where.file = kOverrideFile;
  return node;
}

ComponentNode& viewer_of(Graph& graph) {
  const auto found = std::ranges::find(graph.components, kType, &ComponentNode::type);
  if (found != graph.components.end()) return *found;
  ComponentNode node;
  node.name = node.type = node.process = node.lane = kType;
  node.manager = Manager::none;
  node.where.file = kOverrideFile;
  graph.components.push_back(std::move(node));
  return graph.components.back();
}

int port_of(const std::string& text) {
  int port = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() || port < 0 || port > 65535)
    throw std::runtime_error("--page=" + text + ": must be a port, from 0 (any free one) to 65535");
  return port;
}

}  // namespace

void PageOptions::add_to(cli::Verb verb) {
  verb.flag("--page", kAsGiven, page,
            "Serves the page, and Foxglove, while it runs: --page=PORT (8765, or the next free one)");
  verb.option("--bags", bags, "Folder of recordings that the page may open");
  verb.option("--listen", listen, "Address for others than this machine; needs --token-file");
  verb.option("--token-file", token_file, "File with the token that the page asks for");
  verb.option("--allow-origin", allow_origins,
              "A page of elsewhere that may connect, such as https://app.foxglove.dev; as often as needed")
      .one_each_time();
  verb.flag("--allow-commands", allow_commands, "With --listen: others may command, one at a time");
}

void PageOptions::apply_to(Graph& graph) const {
  const bool is_given = !page.empty() || !bags.empty() || !listen.empty() || !token_file.empty() ||
                        !allow_origins.empty() || allow_commands;
  if (!is_given) return;
  ComponentNode& viewer = viewer_of(graph);
  viewer.enabled = true;
  const auto set = [&](const char* name, ConfigNode value) {
    if (viewer.parameters.is_null()) viewer.parameters.kind = ConfigNode::Kind::kMap;
    apply_override(viewer.parameters, Override{.path = {name}, .value = std::move(value)});
  };
  const auto set_path = [&](const char* name, const std::string& path) {
    if (!path.empty()) set(name, scalar(std::filesystem::absolute(path).string(), true));
  };
  if (!page.empty() && page != kAsGiven) set("port", scalar(std::to_string(port_of(page)), false));
  if (!listen.empty()) set("address", scalar(listen, true));
  set_path("bag_folder", bags);
  set_path("token_file", token_file);
  if (allow_commands) set("allow_commands", scalar("true", false));
  if (allow_origins.empty()) return;
  ConfigNode origins;
  origins.kind = ConfigNode::Kind::kSequence;
  origins.where.file = kOverrideFile;
  for (const std::string& origin : allow_origins) origins.sequence.push_back(scalar(origin, true));
  set("allow_origins", std::move(origins));
}

}  // namespace bw
