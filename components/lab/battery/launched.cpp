#include "components/lab/battery/launched.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "runtime/parameters/own_program.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kLook = std::chrono::milliseconds(20);

template <class Holds>
bool poll_until(double patience, Holds holds) {
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  while (!holds()) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

std::filesystem::path robots_program() {
  const auto program = own_program().parent_path() / "bandwagon";
  if (!std::filesystem::exists(program))
    throw std::runtime_error(program.string() + ": there is no such program");
  return program;
}

Launched::Launched(const std::string& graph, std::vector<std::string> words,
                   const std::filesystem::path& folder)
    : folder_(folder) {
  std::filesystem::create_directories(folder);
  std::vector<std::string> command = {robots_program().string(), "launch", graph, "--logs", folder.string()};
  command.insert(command.end(), words.begin(), words.end());
  process_ = std::make_unique<ChildProcess>(
      ChildProcessOptions{.command = std::move(command), .log = folder / "out.txt", .is_apart = true});
}

std::string Launched::log() const {
  std::ifstream in(folder_ / "launch.log", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool Launched::says(const std::string& text, int times, double patience) {
  bool is_said = false;
  poll_until(patience, [&] {
    is_said = count(log(), text) >= times;
    return is_said || process_->status().has_value();
  });
  return is_said;
}

std::optional<int> Launched::wait(double patience) {
  poll_until(patience, [&] { return process_->status().has_value(); });
  return process_->known_status();
}

std::map<std::string, pid_t> Launched::processes() const {
  std::map<std::string, pid_t> ids;
  std::ifstream manifest(folder_ / "manifest.yaml");
  const std::string mark = ": pid ";  // "planning: pid 1234"
  for (std::string line; std::getline(manifest, line);) {
    if (const std::size_t at = line.find(mark); at != std::string::npos)
      ids[line.substr(0, at)] = std::stoi(line.substr(at + mark.size()));
  }
  return ids;
}

void Launched::interrupt() const { process_->signal(SIGINT); }

}  // namespace bw
