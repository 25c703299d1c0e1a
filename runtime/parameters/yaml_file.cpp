#include "runtime/parameters/yaml_file.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "runtime/parameters/field_types.hpp"

namespace bw {
namespace {

constexpr std::size_t kMaxValueBytes = 4 * kMaxYamlBytes;

struct Extent {
  std::size_t nodes = 0, bytes = 0, depth = 0;
};

Extent extent_of(const ConfigNode& node) {
  Extent sum{1, node.scalar.size(), 0};
  const auto add = [&sum](const ConfigNode& child) {
    const Extent e = extent_of(child);
    sum.nodes += e.nodes;
    sum.bytes += e.bytes;
    sum.depth = std::max(sum.depth, e.depth);
  };
  for (const ConfigNode& child : node.sequence) add(child);
  for (const ConfigEntry& entry : node.map) {
    sum.bytes += entry.key.size();
    add(entry.value);
  }
  ++sum.depth;
  return sum;
}

/// Builds the tree from parser events, so that no limit depends on what the parser library would build
/// itself.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::string file) : file_(std::move(file)) {}

  ConfigNode take_root() { return std::move(root_); }

  /// The dotted key whose value is being read.
  std::string open_key() const {
    std::string key;
    for (const Open& open : open_) {
      if (open.node.is_sequence()) key = joined(key, std::to_string(open.node.sequence.size()));
      if (open.has_key) key = joined(key, open.node.map.back().key);
    }
    return key;
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) refuse(mark, "only one YAML document is allowed in a file");
    root_.where = location(mark);
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (key_expected()) refuse(mark, "a key must be text");
    ConfigNode node;
    // The parser marks the token after the missing value, maybe lines below its key.
    const bool has_key = !open_.empty() && open_.back().has_key;
    node.where = has_key ? open_.back().node.map.back().where : location(mark);
    add(std::move(node), anchor, mark);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_tag(mark, tag);
    if (key_expected()) {
      set_key(mark, value);
      return;
    }
    ConfigNode node;
    node.kind = ConfigNode::Kind::kScalar;
    node.scalar = value;
    node.quoted = tag == "!";
    node.where = location(mark);
    add(std::move(node), anchor, mark);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (key_expected()) refuse(mark, "a key must be text, not an alias");
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) refuse(mark, "an alias must not stand inside its own anchor");
    add(found->second, YAML::NullAnchor, mark);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::kSequence, mark, tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::kMap, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    ConfigNode node;
    YAML::anchor_t anchor = YAML::NullAnchor;
    YAML::Mark mark;
    std::set<std::string, std::less<>> keys;
    bool has_key = false;
  };

  Location location(const YAML::Mark& mark) const { return {file_, mark.line + 1}; }

  [[noreturn]] void refuse(const YAML::Mark& mark, std::string rule) const {
    throw ConfigError(Violation{location(mark), open_key(), {}, std::move(rule)});
  }

  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") refuse(mark, "tags such as !!str are not used here");
  }

  bool key_expected() const { return !open_.empty() && open_.back().node.is_map() && !open_.back().has_key; }

  void set_key(const YAML::Mark& mark, const std::string& key) {
    Open& top = open_.back();
    top.node.map.push_back({key, location(mark), {}});
    top.has_key = true;
    if (!top.keys.insert(key).second) refuse(mark, "this key is given twice");
    count({0, key.size(), 0}, mark);
  }

  void open(ConfigNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    check_tag(mark, tag);
    if (key_expected()) refuse(mark, "a key must be text");
    if (open_.size() >= kMaxYamlDepth) refuse_depth(mark);
    Open next;
    next.node.kind = kind;
    next.node.where = location(mark);
    next.anchor = anchor;
    next.mark = mark;
    open_.push_back(std::move(next));
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    // The children were counted one by one.
    place(std::move(done.node), done.anchor, done.mark, {1, 0, 0});
  }

  void add(ConfigNode node, YAML::anchor_t anchor, const YAML::Mark& mark) {
    const Extent extent = extent_of(node);
    place(std::move(node), anchor, mark, extent);
  }

  void place(ConfigNode node, YAML::anchor_t anchor, const YAML::Mark& mark, const Extent& extent) {
    count(extent, mark);
    if (anchor != YAML::NullAnchor) {
      count(extent_of(node), mark);
      anchors_[anchor] = node;
    }
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (open_.back().node.is_map()) {
      open_.back().node.map.back().value = std::move(node);
      open_.back().has_key = false;
    } else {
      open_.back().node.sequence.push_back(std::move(node));
    }
  }

  void count(const Extent& extent, const YAML::Mark& mark) {
    if (open_.size() + extent.depth > kMaxYamlDepth + 1) refuse_depth(mark);
    nodes_ += extent.nodes;
    bytes_ += extent.bytes;
    if (nodes_ > kMaxYamlNodes) refuse(mark, "more than " + std::to_string(kMaxYamlNodes) + " values");
    if (bytes_ > kMaxValueBytes)
      refuse(mark, "more than " + std::to_string(kMaxValueBytes) + " bytes of values");
  }

  [[noreturn]] void refuse_depth(const YAML::Mark& mark) const {
    refuse(mark, "nested deeper than " + std::to_string(kMaxYamlDepth) + " levels");
  }

  std::string file_;
  ConfigNode root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, ConfigNode> anchors_;
  std::size_t nodes_ = 0;
  std::size_t bytes_ = 0;
  int documents_ = 0;
};

/// Length of the UTF-8 character at `text[i]`, 0 if there is none that a configuration may hold.
std::size_t character_length(std::string_view text, std::size_t i) {
  const auto byte = [&text](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = byte(i);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t length = first >= 0xf5   ? 0
                             : first >= 0xf0 ? 4
                             : first >= 0xe0 ? 3
                             : first >= 0xc2 ? 2
                                             : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  }
  return length;
}

[[noreturn]] void refuse_file(const std::string& file, int line, std::string rule, std::string key = {}) {
  Violation violation;
  violation.where = {file, line};
  violation.key = std::move(key);
  violation.rule = std::move(rule);
  throw ConfigError(std::move(violation));
}

void check_text(std::string_view text, const std::string& file) {
  if (text.size() > kMaxYamlBytes)
    refuse_file(file, 0, "larger than " + std::to_string(kMaxYamlBytes) + " bytes");
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) refuse_file(file, line, "not UTF-8 text");
    if (text[i] == '\n') ++line;
    i += length;
  }
}

}  // namespace

bool is_config_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

ConfigNode parse_yaml(std::string_view text, const std::string& file) {
  check_text(text, file);
  TreeBuilder builder(file);
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    refuse_file(file, std::max(error.mark.line, 0) + 1, "not YAML: " + error.msg, builder.open_key());
  }
  ConfigNode root = builder.take_root();
  if (root.where.file.empty()) root.where = {file, 1};
  return root;
}

ConfigNode load_yaml(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) refuse_file(file, 0, "no such file");
  if (!std::filesystem::is_regular_file(path, error)) refuse_file(file, 0, "not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_file(file, 0, "cannot be read");
  // One byte more than allowed tells a large file from a full one, whatever its size is said to be.
  std::string text(kMaxYamlBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse_file(file, 0, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_yaml(text, file);
}

}  // namespace bw
