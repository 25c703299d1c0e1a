#include "runtime/cli/replay_topics.hpp"

#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "runtime/cli/regex_option.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/terminal.hpp"
#include "runtime/host/statistics.hpp"
#include "runtime/recording/replay/topic_player.hpp"

namespace bw::cli {
namespace {

/// Keys of a terminal, a progress line, Ctrl-C.
class TerminalControl final : public replay::PlayerControl {
 public:
  explicit TerminalControl(Duration length) : length_(length) {}

  [[nodiscard]] bool has_keys() const { return keyboard_.is_there(); }
  Wish wait(Duration limit, const replay::PlayerStatus& status) override {
    if (interrupted()) return Wish::end;
    show(status);
    const std::optional<Key> key = keyboard_.wait(limit);
    if (interrupted()) return Wish::end;
    if (!key) return Wish::none;
    shown_ = {};  // what a key did is seen at once
    switch (*key) {
      case ' ':
        return Wish::pause;
      case kRight:
      case 'n':
        return Wish::step;
      case kUp:
        return Wish::faster;
      case kDown:
        return Wish::slower;
      default:
        break;
    }
    return Wish::none;
  }

 private:
  void show(const replay::PlayerStatus& status) {
    const Duration now = steady_time();
    if (now - shown_ < Duration::milliseconds(100)) return;
    shown_ = now;
    if (status.is_waiting) {
      line_.show("looking for readers");
      return;
    }
    const std::string rate =
        status.rate == 0.0 ? "as fast as possible" : fmt::format("rate {:.1f}", status.rate);
    line_.show(fmt::format("{:.1f} / {:.1f} s | {} | {} messages{}", status.position.to_seconds(),
                           length_.to_seconds(), rate, status.published,
                           status.is_paused ? " | paused: SPACE goes on, RIGHT one message" : ""));
  }

  const Duration length_;
  Keyboard keyboard_;
  ProgressLine line_;
  Duration shown_;
};

std::map<std::string, std::string> remaps_of(const std::vector<std::string>& texts) {
  std::map<std::string, std::string> remaps;
  for (const std::string& text : texts) {
    const std::size_t at = text.find(":=");
    if (at == std::string::npos || at == 0 || at + 2 == text.size())
      throw std::runtime_error("--remap " + text + ": must be /recorded:=/played");
    remaps[text.substr(0, at)] = text.substr(at + 2);
  }
  return remaps;
}

std::unique_ptr<bag::Bag> open_all(const std::vector<std::string>& paths) {
  std::vector<std::unique_ptr<bag::Bag>> bags;
  for (const std::string& path : paths) bags.push_back(bag::open_bag(path));
  return bag::join_bags(std::move(bags));
}

void print(const replay::PlayerStatus& status, std::size_t topics) {
  const double took = status.took.to_seconds();
  std::cout << fmt::format(
      "{} messages of {} topics in {:.3f} s, {} from before the start; at most {:.3f} ms late\n",
      status.published, topics, took, status.latched, status.latest.to_seconds() * 1e3);
  if (status.malformed > 0)
    std::cout << status.malformed << " messages do not fit their type: not published\n";
  if (status.refused > 0) std::cout << status.refused << " messages were refused by DDS\n";
}

}  // namespace

void add_replay_topics_options(Verb verb, ReplayTopicsOptions& options) {
  constexpr const char* kGroup = "As topics, in real time (without --graph)";
  verb.option("-r,--rate", options.rate, "Bag seconds per second; 0 as fast as possible")
      .not_negative()
      .under(kGroup);
  verb.option("--start", options.start_s, "Begins so many seconds behind the bag's beginning")
      .not_negative()
      .under(kGroup);
  verb.option("--duration", options.duration_s, "Ends after so many seconds of the bag")
      .positive()
      .under(kGroup);
  verb.option("--topics", options.topics, "Only these").under(kGroup);
  verb.option("--exclude", options.exclude, "Not what this regular expression finds").under(kGroup);
  verb.option("--remap", options.remap, "/recorded:=/played, as many as needed").under(kGroup);
  verb.option("--wait-for", options.wait_for, "Begins when somebody reads these topics").under(kGroup);
  verb.flag("--pause", options.pause,
            "Begins paused. Keys: SPACE pause, RIGHT or n next message, UP and DOWN rate")
      .under(kGroup);
}

std::string given_replay_topics_option(Verb verb) {
  for (const char* name :
       {"--rate", "--start", "--duration", "--topics", "--exclude", "--remap", "--wait-for", "--pause"}) {
    if (verb.has(name)) return name;
  }
  return {};
}

int replay_topics(const std::vector<std::string>& paths, const ReplayTopicsOptions& options,
                  std::optional<double> clock_hz) {
  const auto recording = open_all(paths);
  for (const bag::BagFault& fault : recording->faults())
    std::cerr << fmt::format("{}: byte {}: {}\n", fault.file.string(), fault.offset, fault.what);
  catch_interrupts();
  replay::TopicPlayer player(
      *recording, {.selection = {.topics = options.topics,
                                 .exclude = to_regex("--exclude", options.exclude),
                                 .remaps = remaps_of(options.remap)},
                   .network = dds::Network::from_environment(dds::Transport::localhost),
                   .rate = options.rate,
                   .start = Duration::seconds(options.start_s),
                   .duration = options.duration_s > 0.0 ? std::optional(Duration::seconds(options.duration_s))
                                                        : std::nullopt,
                   .clock_hz = clock_hz,
                   .is_paused = options.pause,
                   .wait_for = options.wait_for});
  replay::PlayerStatus status;
  {
    TerminalControl control(recording->end() - recording->start());
    if (options.pause && !control.has_keys())
      throw std::runtime_error("--pause needs a terminal: without keys nothing would end the pause");
    status = player.run(control);
  }
  print(status, player.topics());
  for (const bag::BagFault& fault : player.faults())
    std::cerr << fmt::format("{}: byte {}: {}\n", fault.file.string(), fault.offset, fault.what);
  return interrupted() || !player.faults().empty() ? 1 : 0;
}

}  // namespace bw::cli
