// The hallway without walkers, launched by the program: its words, its log, what it says to whom asks.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {

inline std::vector<std::string> command(const Folder& folder, const std::vector<std::string>& options) {
  std::vector<std::string> words = {BANDWAGON_PROGRAM,
                                    "launch",
                                    "hallway",
                                    "--logs",
                                    folder / "logs",
                                    "--set",
                                    "world.people.social.walkers=[]"};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

inline Outcome launch(const Folder& folder, const std::vector<std::string>& options) {
  return run_to_end(command(folder, options), std::chrono::seconds(60));
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The graph, launched, and asked about from outside.
class Launched {
 public:
  explicit Launched(const std::vector<std::string>& options) : process_(command(folder, options)) {}

  /// What `bandwagon launch QUESTION hallway ...` says.
  static std::string ask(std::vector<std::string> question) {
    question.insert(question.begin(), {BANDWAGON_PROGRAM, "launch"});
    question.insert(question.begin() + 3, "hallway");
    const Outcome outcome = run_to_end(question, std::chrono::seconds(30));
    return outcome.out + outcome.err;
  }
  static bool status_has(const std::string& pattern) {
    const std::regex wanted(pattern);
    return eventually([&] { return std::regex_search(ask({"status"}), wanted); });
  }
  static pid_t id(const std::string& name) {
    std::smatch found;
    const std::string text = ask({"status"});
    return std::regex_search(text, found, std::regex(name + " .*pid (\\d+)")) ? std::stoi(found[1]) : 0;
  }
  Process& process() { return process_; }

  Folder folder;

 private:
  Process process_;
};

}  // namespace bw::test
