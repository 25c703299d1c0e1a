#include "runtime/cli/verb.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <stdexcept>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "runtime/cli/completion.hpp"

namespace bw::cli {
namespace {

constexpr const char* kHeadings[] = {"Drive", "Look", "Measure"};

struct Registered {
  std::string help;
  AddVerb add;
};
using Verbs = std::map<std::pair<VerbGroup, std::string>, Registered>;

Verbs& verbs() {
  static Verbs all;
  return all;
}

CLI::Option* add(CLI::App& app, const std::string& names, std::function<void(const std::string&)> tell,
                 const std::string& help) {
  return app.add_option_function<std::string>(names, tell, help);
}

CLI::Option* add(CLI::App& app, const std::string& names,
                 std::function<void(const std::vector<std::string>&)> tell, const std::string& help) {
  return app.add_option_function<std::vector<std::string>>(names, tell, help);
}

/// Values that options take alone, for completion.
std::map<const CLI::Option*, std::vector<std::string>>& choices() {
  static std::map<const CLI::Option*, std::vector<std::string>> all;
  return all;
}

/// What all verbs are behind.
class Program : public CLI::App {
 public:
  using CLI::App::App;
  static Program& of(CLI::App& verb) {
    CLI::App* app = &verb;
    while (app->get_parent() != nullptr) app = app->get_parent();
    return static_cast<Program&>(*app);
  }

  int status = 0;
};

template <class T>
CLI::Option* add(CLI::App& app, const std::string& names, T* value, const std::string& help) {
  return app.add_option(names, *value, help);
}

}  // namespace

Option Option::required() const { return Option(option_->required()); }

Option Option::one_of(std::initializer_list<const char*> values) const {
  const std::vector<std::string> all(values.begin(), values.end());
  choices()[option_] = all;
  return Option(option_->check(CLI::IsMember(all)));
}

Option Option::within(double least, double most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::within(int least, int most) const { return Option(option_->check(CLI::Range(least, most))); }

Option Option::positive() const { return Option(option_->check(CLI::PositiveNumber)); }

Option Option::not_negative() const { return Option(option_->check(CLI::NonNegativeNumber)); }

Option Option::existing_file() const { return Option(option_->check(CLI::ExistingFile)); }

Option Option::existing_folder() const { return Option(option_->check(CLI::ExistingDirectory)); }

Option Option::separated_by_commas() const { return Option(option_->delimiter(',')); }

Option Option::one_each_time() const { return Option(option_->allow_extra_args(false)); }

Option Option::optional_value() const { return Option(option_->expected(0, 1)); }

Option Option::shows_default() const { return Option(option_->capture_default_str()); }

Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }

Option Option::under(const std::string& heading) const { return Option(option_->group(heading)); }

Option Verb::add_option(const std::string& names, OptionTarget target, const std::string& help) {
  return Option(std::visit([&](auto& to) { return add(*app_, names, std::move(to), help); }, target));
}

Option Verb::flag(const std::string& names, bool& value, const std::string& help) {
  return Option(app_->add_flag(names, value, help));
}

Option Verb::flag(const std::string& name, const std::string& alone, std::string& value,
                  const std::string& help) {
  return Option(app_->add_flag(name + "{" + alone + "}", value, help));
}

Verb Verb::verb(const std::string& name, const std::string& help) {
  app_->require_subcommand(1);
  return Verb(app_->add_subcommand(name, help));
}

void Verb::set_action(std::function<int()> action) {
  app_->callback([app = app_, action] {
    if (app->get_subcommands().empty()) Program::of(*app).status = action();
  });
}

void Verb::stands_alone_too() { app_->require_subcommand(0, 1); }

std::vector<std::pair<std::string, std::string>> Verb::given() const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const CLI::Option* option : app_->get_options()) {
    if (option->get_positional() || option->get_lnames().empty()) continue;
    const std::string name = "--" + option->get_lnames().front();
    const bool is_flag = option->get_items_expected_max() == 0;
    for (const std::string& value : option->results()) {
      const bool stands_alone =
          is_flag && (value == "true" || value == option->get_flag_value(name.substr(2), ""));
      all.emplace_back(name, stands_alone ? name : name + "=" + value);
    }
  }
  return all;
}

void Verb::alias(const std::string& name) { app_->alias(name); }

bool Verb::has(const std::string& name) const { return app_->count(name) > 0; }

namespace {

/// Which part of the command line comes next.
struct Awaited {
  const CLI::App* verb;
  const CLI::Option* option = nullptr;  ///< whose value it is
  std::size_t positionals = 0;          ///< before it
};

const CLI::App* verb_of(const CLI::App& app, const std::string& name) {
  const std::vector<const CLI::App*> found =
      app.get_subcommands([&name](const CLI::App* verb) { return verb->check_name(name); });
  return found.empty() ? nullptr : found.front();
}

Awaited awaited_after(const CLI::App& program, const std::vector<std::string>& words) {
  Awaited next{.verb = &program};
  for (const std::string& word : words) {
    if (next.option != nullptr) {
      next.option = nullptr;
    } else if (word.starts_with("-")) {
      const CLI::Option* option = next.verb->get_option_no_throw(word);
      if (option != nullptr && option->get_items_expected_max() > 0) next.option = option;
    } else if (const CLI::App* verb = verb_of(*next.verb, word)) {
      next = {.verb = verb};
    } else {
      ++next.positionals;
    }
  }
  return next;
}

std::vector<std::string> values_for(const CLI::Option& option, const std::vector<std::string>& words,
                                    const std::string& begun) {
  if (const auto known = choices().find(&option); known != choices().end()) return known->second;
  const std::string name = option.get_positional() ? option.get_name(true) : "--" + option.get_single_name();
  return value_candidates(name, words, begun);
}

std::vector<std::string> candidates(const CLI::App& program, std::vector<std::string> words) {
  const std::string begun = words.empty() ? "" : words.back();
  if (!words.empty()) words.pop_back();
  const Awaited next = awaited_after(program, words);
  if (next.option != nullptr) return values_for(*next.option, words, begun);
  std::vector<std::string> all;
  std::vector<const CLI::Option*> positionals;
  for (const CLI::Option* option : next.verb->get_options()) {
    if (option->get_positional()) positionals.push_back(option);
    for (const std::string& name : option->get_lnames()) {
      if (begun.starts_with("-")) all.push_back("--" + name);
    }
  }
  if (begun.starts_with("-")) return all;
  for (const CLI::App* verb : next.verb->get_subcommands([](const CLI::App*) { return true; })) {
    if (next.positionals == 0) all.push_back(verb->get_name());
  }
  if (next.positionals < positionals.size()) {
    for (std::string& value : values_for(*positionals[next.positionals], words, begun))
      all.push_back(std::move(value));
  }
  return all;
}

/// `complete WORDS...`, as completion of the shells calls it: a line for each candidate. Whatever is wrong with
/// the words, a shell wants to hear nothing of it.
int print_candidates(const CLI::App& program, const std::vector<std::string>& words) {
  try {
    const std::string begun = words.empty() ? "" : words.back();
    for (const std::string& candidate : candidates(program, words)) {
      if (candidate.starts_with(begun)) std::cout << candidate << "\n";
    }
  } catch (const std::exception&) {
    return 1;
  }
  return 0;
}

}  // namespace

bool register_verb(VerbGroup group, std::string_view name, std::string_view help, AddVerb add) {
  if (!verbs().emplace(std::pair(group, std::string(name)), Registered{std::string(help), add}).second)
    throw std::logic_error("two verbs call themselves " + std::string(name));
  return true;
}

int run_verb(const std::string& name, const std::string& help, const std::function<std::string()>& version,
             int argc, char** argv) {
  Program program(help, name);
  program.require_subcommand(1);
  program.set_version_flag("--version", version);
  for (const auto& [key, verb] : verbs()) {
    CLI::App* app = program.add_subcommand(key.second, verb.help);
    verb.add(Verb(app));
    app->group(kHeadings[static_cast<int>(key.first)]);  // behind its own verbs, which would inherit it
  }
  if (argc > 1 && std::string_view(argv[1]) == "complete")
    return print_candidates(program, std::vector<std::string>(argv + 2, argv + argc));
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  return program.status;
}

}  // namespace bw::cli
