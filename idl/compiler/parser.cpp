#include "idl/compiler/parser.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>

#include "idl/compiler/derive.hpp"
#include "idl/compiler/lexer.hpp"
#include "idl/compiler/names.hpp"

namespace bw::idl {
namespace {

constexpr std::pair<std::string_view, Kind> kPrimitives[] = {
    {"boolean", Kind::kBoolean}, {"octet", Kind::kByte},    {"int8", Kind::kInt8},
    {"uint8", Kind::kUint8},     {"int16", Kind::kInt16},   {"uint16", Kind::kUint16},
    {"int32", Kind::kInt32},     {"uint32", Kind::kUint32}, {"int64", Kind::kInt64},
    {"uint64", Kind::kUint64},   {"float", Kind::kFloat32}, {"double", Kind::kFloat64},
};

std::optional<Kind> primitive(std::string_view name) {
  const auto* found = std::find_if(std::begin(kPrimitives), std::end(kPrimitives),
                                   [&](const auto& entry) { return entry.first == name; });
  return found == std::end(kPrimitives) ? std::nullopt : std::optional(found->second);
}

/// Of services and actions also with the part it is: Trigger_Request.
bool is_struct_name(std::string_view name) { return is_type_name(name.substr(0, name.find('_'))); }

class Parser {
 public:
  Parser(std::string_view text, const std::string& path)
      : path_(path), distro_(interface_of(path).distro), tokens_(tokenize(text, path)) {}

  File run() {
    File file;
    file.path = path_;
    file.comment = now().comment;
    while (now().type == Token::Type::kInclude) file.includes.push_back(next().text);
    while (now().type != Token::Type::kEnd) {
      const std::string package = open_module();
      while (!accept("}")) {
        const std::string category = open_module();
        while (!accept("}")) definition(package, category, file);
        expect(";");
      }
      expect(";");
    }
    file.lines = now().line;
    derive(file);
    return file;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw std::runtime_error(path_ + ":" + std::to_string(now().line) + ": expected " + expected +
                             ", found '" + now().text + "'");
  }

  [[nodiscard]] const Token& now() const { return tokens_[at_]; }
  const Token& next() { return tokens_[now().type == Token::Type::kEnd ? at_ : at_++]; }

  bool accept(std::string_view text) {
    if (now().type == Token::Type::kEnd || now().text != text) return false;
    next();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) fail("'" + std::string(text) + "'");
  }
  std::string word(const char* expected) {
    if (now().type != Token::Type::kWord) fail(expected);
    return next().text;
  }
  std::string name(const char* expected, bool (*valid)(std::string_view)) {
    if (!valid(now().text)) fail(expected);
    return word(expected);
  }
  std::uint32_t positive() {
    const std::string text = word("a positive number");
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == 0)
      fail("a positive number before");
    return value;
  }

  std::string open_module() {
    expect("module");
    std::string result = name("a module's name in lower_case", is_field_name);
    expect("{");
    return result;
  }

  void definition(const std::string& package, const std::string& category, File& file) {
    if (accept("module")) {
      const int line = now().line;
      Constants result{{package, category, word("a module's name"), distro_}, {}, line};
      if (!result.name.ends_with("_Constants")) fail("a module named <Name>_Constants before");
      expect("{");
      while (!accept("}")) result.values.push_back(constant());
      file.constants.push_back(std::move(result));
    } else {
      expect("struct");
      const int line = now().line;
      Struct result{
          {package, category,
           name("a struct's name in CamelCase", category == "msg" ? is_type_name : is_struct_name), distro_},
          {},
          line};
      expect("{");
      while (!accept("}")) result.members.push_back(member());
      if (result.members.empty())
        fail("a member (ROS 2 writes '" + std::string(kEmptyMessageMember) + "') before");
      file.structs.push_back(std::move(result));
    }
    expect(";");
  }

  Constant constant() {
    expect("const");
    Constant result;
    result.comment = tokens_[at_ - 1].comment;
    const auto kind = primitive(word("a type"));
    if (!kind) fail("a number's type before");
    result.kind = *kind;
    result.name = name("a constant's name in UPPER_CASE", is_constant_name);
    expect("=");
    if (accept("-")) result.value = "-";
    result.value += word("a number");
    expect(";");
    return result;
  }

  Member member() {
    Member result;
    result.comment = now().comment;
    if (accept("sequence")) {
      result.shape = Shape::kSequence;
      expect("<");
      element(result);
      if (accept(",")) result.capacity = positive();
      expect(">");
    } else {
      element(result);
    }
    result.name = name("a member's name in lower_case", is_field_name);
    if (accept("[")) {
      if (result.shape == Shape::kSequence) fail("';' (no arrays of sequences)");
      result.shape = Shape::kArray;
      result.capacity = positive();
      expect("]");
    }
    expect(";");
    return result;
  }

  void element(Member& result) {
    const std::string name = word("a type");
    if (const auto kind = primitive(name)) {
      result.kind = *kind;
    } else if (name == "string") {
      result.kind = Kind::kString;
      if (accept("<")) {
        result.string_capacity = positive();
        expect(">");
      }
    } else {
      result.kind = Kind::kMessage;
      expect("::");
      const std::string category = word("msg, srv or action");
      expect("::");
      result.message = name + "/" + category + "/" + word("a type's name");
    }
  }

  const std::string& path_;
  std::string distro_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

/// The key of what `member` of `user` is, `defined` holding the keys of all types.
template <class Keys>
std::string nested_key(const Keys& defined, const Struct& user, const Member& member) {
  const std::string own = user.distro + "/" + member.message;
  return defined.contains(own) ? own : member.message;
}

/// A struct may use what its file defines before it and what the file's includes define, directly or through
/// theirs.
class Linker {
 public:
  explicit Linker(const std::vector<File>& files) {
    for (const File& file : files) {
      files_.emplace(file.path, file);
      for (const Struct& type : file.structs) defined_.insert(type.key());
    }
  }

  Types run() {
    for (const auto& [path, file] : files_) visible_from(file);
    return std::move(types_);
  }

 private:
  const std::set<std::string>& visible_from(const File& file) {
    if (const auto done = visible_.find(file.path); done != visible_.end()) return done->second;
    if (!open_.insert(file.path).second) throw std::runtime_error(file.path + ": includes itself");
    std::set<std::string> visible;
    for (const std::string& include : file.includes) {
      const auto found = files_.find(include);
      if (found == files_.end()) throw std::runtime_error(file.path + ": no such file: " + include);
      visible.merge(std::set<std::string>(visible_from(found->second)));
    }
    for (const Struct& type : file.structs) {
      for (const Member& member : type.members) {
        if (member.kind != Kind::kMessage) continue;
        const std::string key = nested_key(defined_, type, member);
        if (!visible.contains(key)) {
          throw std::runtime_error(file.path + ": " + type.name + "." + member.name + " has unknown type " +
                                   key + " (missing #include?)");
        }
      }
      if (!types_.emplace(type.key(), type).second) {
        throw std::runtime_error(file.path + ": " + type.key() + " is defined twice");
      }
      visible.insert(type.key());
    }
    return visible_.emplace(file.path, std::move(visible)).first->second;
  }

  std::map<std::string, File> files_;
  std::set<std::string> defined_;
  std::map<std::string, std::set<std::string>> visible_;
  std::set<std::string> open_;
  Types types_;
};

}  // namespace

Interface interface_of(const std::string& path) {
  const std::filesystem::path parts(path);
  const std::filesystem::path package = parts.parent_path().parent_path();
  const bool is_base = package.parent_path().parent_path() != "distros";
  return {is_base ? package.string() : package.filename().string(), parts.parent_path().filename().string(),
          parts.stem().string(), is_base ? "" : package.parent_path().filename().string()};
}

const Struct& nested(const Types& types, const Struct& user, const Member& member) {
  return types.at(nested_key(types, user, member));
}

File parse(std::string_view text, const std::string& path) { return Parser(text, path).run(); }

Types link(const std::vector<File>& files) { return Linker(files).run(); }

}  // namespace bw::idl
