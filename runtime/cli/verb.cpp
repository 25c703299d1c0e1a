#include "runtime/cli/verb.hpp"

#include <map>
#include <stdexcept>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

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
  return Option(option_->check(CLI::IsMember(std::vector<std::string>(values.begin(), values.end()))));
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
  app_->callback([app = app_, action] { Program::of(*app).status = action(); });
}

void Verb::alias(const std::string& name) { app_->alias(name); }

bool Verb::has(const std::string& name) const { return app_->count(name) > 0; }

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
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  return program.status;
}

}  // namespace bw::cli
