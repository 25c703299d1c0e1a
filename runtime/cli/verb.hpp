// Verbs of the program `bandwagon`. One joins by a few lines in its own source file,
//
//   void add_list(Verb verb) {
//     verb.flag("--json", options->json, "As JSON");
//     verb.run([options] { return list(*options); });
//   }
//   BW_VERB(look, "list", "Component types this program knows", add_list)
//
// and by `bw_verb(list SOURCES list.cpp)` in its CMakeLists.txt. Exit status of every verb: 0 done, 1 the job
// failed, 2 wrong use or configuration (ConfigError or std::runtime_error while configuring).
//
// CLI11 reads the command line; it is included by verb.cpp alone, since it costs each source five seconds of
// compiling.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bw::cli {

/// Where the value of an option goes, or who is told of it.
using OptionTarget = std::variant<
    std::string*, std::filesystem::path*, bool*, int*, std::uint16_t*, std::uint64_t*, double*,
    std::optional<std::string>*, std::optional<double>*, std::optional<int>*, std::optional<std::uint64_t>*,
    std::vector<std::string>*, std::vector<std::filesystem::path>*, std::vector<double>*,
    std::function<void(const std::string&)>, std::function<void(const std::vector<std::string>&)>>;

/// A handle; the program owns what it stands for.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  Option one_of(std::initializer_list<const char*> values) const;
  Option within(double least, double most) const;
  Option within(int least, int most) const;
  Option positive() const;
  Option not_negative() const;
  Option existing_file() const;
  Option existing_folder() const;
  /// Values in one word, separated by commas.
  Option separated_by_commas() const;
  /// A list takes one value each time that it is given, and not all that follow.
  Option one_each_time() const;
  /// May be given without a value.
  Option optional_value() const;
  Option shows_default() const;
  Option needs(Option other) const;
  /// The heading of --help that it stands under.
  Option under(const std::string& heading) const;

 private:
  CLI::Option* option_;
};

/// A handle; the program owns what it stands for.
class Verb {
 public:
  explicit Verb(CLI::App* app) : app_(app) {}

  /// `names`: "-t,--types", or "TOPIC" for what has no dash and goes by its position.
  template <class T>
  Option option(const std::string& names, T& value, const std::string& help = {}) {
    return add_option(names, &value, help);
  }
  Option option_function(const std::string& names, std::function<void(const std::string&)> tell,
                         const std::string& help) {
    return add_option(names, std::move(tell), help);
  }
  Option list_function(const std::string& names, std::function<void(const std::vector<std::string>&)> tell,
                       const std::string& help) {
    return add_option(names, std::move(tell), help);
  }
  Option flag(const std::string& names, bool& value, const std::string& help);
  /// One that may carry a value, `--page=8765`; `alone` is what it means without.
  Option flag(const std::string& name, const std::string& alone, std::string& value, const std::string& help);

  /// A verb behind this one; then one of those has to be given.
  Verb verb(const std::string& name, const std::string& help);
  /// It may be given without any of those.
  void stands_alone_too();
  /// What it does; returns the exit status, or nothing for 0.
  template <class Action>
  void run(Action action) {
    if constexpr (std::is_void_v<std::invoke_result_t<Action>>) {
      set_action([action] {
        action();
        return 0;
      });
    } else {
      set_action(action);
    }
  }
  /// Whether the option was given.
  bool has(const std::string& name) const;
  /// The options that were given, by name, each with the word that gives it again: --set, --set=people.enabled=false.
  std::vector<std::pair<std::string, std::string>> given() const;
  /// Another name for it.
  void alias(const std::string& name);

 private:
  void set_action(std::function<int()> action);
  Option add_option(const std::string& names, OptionTarget target, const std::string& help);

  CLI::App* app_;
};

/// Headings of `bandwagon --help`, in their order.
enum class VerbGroup { drive, look, measure };

using AddVerb = void (*)(Verb verb);

/// Throws std::logic_error when the name is taken.
bool register_verb(VerbGroup group, std::string_view name, std::string_view help, AddVerb add);

/// Reads the command line and runs the verb that it names; returns its exit status. What the verb throws
/// comes through.
int run_verb(const std::string& name, const std::string& help, const std::function<std::string()>& version,
             int argc, char** argv);

}  // namespace bw::cli

/// Once per verb, in its source file.
#define BW_VERB(group, name, help, add)                                       \
  namespace {                                                                 \
  [[maybe_unused]] const bool verb_##add =                                    \
      ::bw::cli::register_verb(::bw::cli::VerbGroup::group, name, help, add); \
  }
