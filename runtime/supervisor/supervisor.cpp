#include "runtime/supervisor/supervisor.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "runtime/child_process.hpp"
#include "runtime/parameters/xdg_folder.hpp"
#include "runtime/supervisor/child_stream.hpp"
#include "runtime/supervisor/credential_socket.hpp"
#include "runtime/supervisor/rotating_log.hpp"
#include "runtime/supervisor/supervisor_lock.hpp"

namespace bw {
namespace {

using std::chrono::milliseconds;
using State = SupervisedProcess::State;
using Act = SupervisedProcess::Act;

Duration steady_now() {
  return Duration{std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

/// Of a child that begins: what it takes later counts, and is inherited by what it starts.
void limit(pid_t child, const SupervisedProgram& program) {
  if (program.memory) {
    const rlimit most{.rlim_cur = *program.memory, .rlim_max = *program.memory};
    prlimit(child, RLIMIT_DATA, &most, nullptr);
  }
  cpu_set_t mine;
  if (!program.cores || sched_getaffinity(0, sizeof(mine), &mine) != 0) return;
  // The last of those that we may use: who has no limit has the first to himself.
  cpu_set_t its;
  CPU_ZERO(&its);
  int left = *program.cores;
  for (int core = CPU_SETSIZE - 1; core >= 0 && left > 0; --core) {
    if (!CPU_ISSET(core, &mine)) continue;
    CPU_SET(core, &its);
    --left;
  }
  sched_setaffinity(child, sizeof(its), &its);
}

struct Child {
  Child(SupervisedProgram its_program, const SupervisorOptions& options)
      : program(std::move(its_program)),
        plan(options.limits),
        out(options.logs / (program.name + ".out"), STDOUT_FILENO),
        err(options.logs / (program.name + ".log"), STDERR_FILENO) {}

  SupervisedProgram program;
  SupervisedProcess plan;
  ChildStream out, err;
  std::unique_ptr<ChildProcess> process;
  Descriptor end;  ///< readable when it has ended
};

class Supervisor {
 public:
  Supervisor(const SupervisorLock& lock, SupervisorOptions options)
      : options_(std::move(options)),
        path_(lock.socket()),
        kept_(path_.string() + ".kept"),
        socket_(path_),
        log_(options_.logs / "launch.log") {
    std::filesystem::remove_all(kept_);
    for (const SupervisedProgram& program : options_.programs)
      children_.push_back(std::make_unique<Child>(program, options_));
  }

  ~Supervisor() {
    std::error_code ignored;
    std::filesystem::remove_all(kept_, ignored);
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  int run() {
    while (!is_over()) {
      if (options_.interrupted() && !ends_) end_all("interrupted");
      if (ends_) end_the_last();
      for (const auto& child : children_) act(*child);
      wait();
      // Who has ended by now has said all that is heard below.
      for (const auto& child : children_) {
        if (child->process) static_cast<void>(child->process->status());
      }
      for (auto datagram = socket_.receive(); datagram; datagram = socket_.receive()) hear(*datagram);
      for (const auto& child : children_) look_after(*child);
    }
    return worst();
  }

 private:
  [[nodiscard]] bool is_over() const {
    return std::ranges::all_of(children_, [](const auto& child) { return child->plan.is_done(); });
  }

  void tell(const std::string& line) {
    pass_on(STDERR_FILENO, "[launch] " + line + "\n");
    log_.write(line + "\n");
  }
  void note(const std::string& line) {
    std::ofstream(options_.logs / "manifest.yaml", std::ios::app) << line << "\n";
  }

  void end_all(const std::string& why) {
    ends_ = true;
    tell("all processes end: " + why);
    for (const auto& child : children_) {
      if (!child->program.ends_last) child->plan.ask_to_end(false);
    }
  }
  /// Who hears the others ends behind them.
  void end_the_last() {
    const bool others_are_gone = std::ranges::all_of(
        children_, [](const auto& child) { return child->program.ends_last || child->plan.is_done(); });
    if (!others_are_gone) return;
    for (const auto& child : children_) child->plan.ask_to_end(false);
  }

  void act(Child& child) {
    switch (child.plan.next(steady_now())) {
      case Act::nothing:
        return;
      case Act::start:
        return start(child);
      case Act::terminate:
        return child.process->signal(SIGTERM);
      case Act::kill:
        tell(fmt::format("{} is killed: {}", child.program.name, child.plan.fault()));
        return child.process->signal(SIGKILL);
    }
  }

  void start(Child& child) {
    const int number = child.plan.starts() + 1;
    std::map<std::string, std::string> environment = {
        {"NOTIFY_SOCKET", path_.string()},
        {"WATCHDOG_USEC", std::to_string(options_.limits.watchdog.nanoseconds / 1000)},
        {"BANDWAGON_STARTED_AGAIN", child.plan.last_end()},
        {"BANDWAGON_LAUNCHED_AT", std::to_string(began_.nanoseconds)},
        {"RUNTIME_DIRECTORY", (kept_ / child.program.name).string()}};
    child.plan.started(steady_now());
    try {
      const Descriptor out = child.out.open();
      const Descriptor err = child.err.open();
      child.process =
          std::make_unique<ChildProcess>(ChildProcessOptions{.command = child.program.command(number),
                                                             .environment = std::move(environment),
                                                             .outputs = std::pair(out.get(), err.get()),
                                                             .is_apart = true});
      limit(child.process->id(), child.program);
      child.end = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child.process->id(), 0)));
    } catch (const std::runtime_error& error) {
      return ended(child, 127, error.what());
    }
    note(fmt::format("{}: pid {}", child.program.name, child.process->id()));
  }

  /// Until something happens, or it is time to look whether something has not.
  void wait() const {
    constexpr int kLook = 20;  // [ms]
    std::vector<pollfd> watched = {{.fd = socket_.descriptor(), .events = POLLIN, .revents = 0}};
    for (const auto& child : children_) {
      for (const int descriptor : {child->end.get(), child->out.descriptor(), child->err.descriptor()})
        if (descriptor >= 0) watched.push_back({.fd = descriptor, .events = POLLIN, .revents = 0});
    }
    poll(watched.data(), watched.size(), kLook);
  }

  void hear(const CredentialSocket::Datagram& datagram) {
    const auto child = std::ranges::find_if(
        children_, [&](const auto& one) { return one->process && one->process->id() == datagram.pid; });
    if (child != children_.end()) {
      const bool was_up = (*child)->plan.state() == State::up;
      (*child)->plan.heard(parse_notification(datagram.text), steady_now());
      if (!was_up && (*child)->plan.state() == State::up)
        tell(fmt::format("{} is up after {:.3f} s: pid {}", (*child)->program.name,
                         (*child)->plan.time_to_ready()->to_seconds(), datagram.pid));
      return;
    }
    if (datagram.uid == geteuid() && !datagram.from.empty())
      return socket_.answer(datagram, answer_to(datagram.text));
    constexpr std::size_t kMostTold = 10;
    if (strangers_.size() < kMostTold && strangers_.insert(datagram.pid).second)
      tell(fmt::format("not believed: process {} of user {} is none of ours", datagram.pid, datagram.uid));
  }

  std::string answer_to(const std::string& question) {
    if (question == "status") return status();
    if (question == "stop") {
      if (!ends_) end_all("asked by `launch stop`");
      return "all processes end\n";
    }
    constexpr std::string_view kRestart = "restart";
    if (!question.starts_with(kRestart)) return "! not understood: " + question.substr(0, 100);
    const std::string name = question.substr(std::min(question.size(), kRestart.size() + 1));
    if (ends_) return "! all processes end";
    bool is_known = false;
    for (const auto& child : children_) {
      if (!name.empty() ? child->program.name != name : child->program.ends_last) continue;
      is_known = true;
      child->plan.ask_to_end(true);
    }
    return is_known ? "started again once at rest\n" : "! there is no process \"" + name + "\"";
  }

  [[nodiscard]] std::string status() const {
    std::string text;
    for (const auto& child : children_) {
      const SupervisedProcess& plan = child->plan;
      text += fmt::format("{:14} {:9} pid {:<8} starts {}", child->program.name, text_of(plan.state()),
                          child->process ? child->process->id() : 0, plan.starts());
      if (plan.time_to_ready())
        text += fmt::format(", up after {:.3f} s", plan.time_to_ready()->to_seconds());
      if (!plan.status().empty()) text += ", says: " + plan.status();
      if (!plan.last_end().empty()) text += fmt::format("\n{:14} before it: {}", "", plan.last_end());
      text += "\n";
    }
    return text + "logs: " + options_.logs.string() + "\n";
  }

  void look_after(Child& child) {
    for (ChildStream* stream : {&child.out, &child.err}) {
      stream->drain();
      if (const std::string fault = stream->news_of_fault(); !fault.empty())
        tell(fmt::format("{}; what {} prints is lost there, and the run goes on", fault, child.program.name));
    }
    if (!child.process) return;
    if (const std::optional<int> status = child.process->known_status())
      ended(child, *status, child.err.last_words());
  }

  void ended(Child& child, int status, const std::string& last_words) {
    const State before = child.plan.state();
    for (ChildStream* stream : {&child.out, &child.err}) {
      stream->drain();
      stream->close_pipe();
    }
    child.process.reset();
    child.end.reset();
    child.plan.ended(status, last_words, steady_now());
    note(fmt::format("{}: exit status {}", child.program.name, status));
    const bool is_again = child.plan.state() == State::waiting;
    if (is_again || !child.plan.given_up().empty() || before != State::stopping)
      tell(fmt::format("{} {}{}", child.program.name, child.plan.last_end(),
                       is_again ? "; it is started again" : ""));
    if (is_again && ends_) child.plan.ask_to_end(false);
    if (ends_ || is_again) return;
    end_all(child.plan.given_up().empty() ? child.program.name + " is over"
                                          : child.program.name + " is given up: " + child.plan.given_up());
  }

  [[nodiscard]] int worst() const {
    int worst = 0;
    for (const auto& child : children_)
      worst =
          std::max({worst, child->plan.last_status().value_or(0), child->plan.given_up().empty() ? 0 : 1});
    return worst;
  }

  SupervisorOptions options_;
  std::filesystem::path path_;
  std::filesystem::path kept_;  ///< by processes for those that are started in their place
  CredentialSocket socket_;
  RotatingLog log_;
  std::vector<std::unique_ptr<Child>> children_;
  const Duration began_ = steady_now();
  std::set<pid_t> strangers_;
  bool ends_ = false;
};

}  // namespace

std::filesystem::path supervisor_socket(const std::string& what) {
  const std::filesystem::path folder = xdg_folder("XDG_RUNTIME_DIR", ".local/state");
  if (folder.empty())
    throw std::runtime_error("there is no folder for a socket: set XDG_RUNTIME_DIR or HOME");
  std::filesystem::create_directories(folder);
  return folder / fmt::format("launch_{:016x}", std::hash<std::string>{}(what));
}

int supervise(const SupervisorLock& lock, SupervisorOptions options) {
  return Supervisor(lock, std::move(options)).run();
}

std::string ask_supervisor(const std::filesystem::path& socket, const std::string& question) {
  const auto answer = CredentialSocket::ask(socket, question, milliseconds(3000));
  if (!answer) throw std::runtime_error("nobody launches it: no supervisor answers at " + socket.string());
  if (answer->starts_with("! ")) throw std::runtime_error(answer->substr(2));
  if (question == "stop") SupervisorLock::wait_until_free(socket);
  return *answer;
}

}  // namespace bw
