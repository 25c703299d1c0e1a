// Every sequence of events that a state machine can meet, up to a depth: breadth first, so that the first
// sequence that breaks the invariant is a shortest one. Sequences that lead to the same state are followed as
// one; what is counted is all of them, n + n^2 + ... + n^depth for n events.
//
//   struct Door { bool is_open = false; ... };
//   Sequences<Door> doors{.make = [] { return Door{}; },
//                         .events = {{"open", [](Door& d) { d.open(); }}, {"close", [](Door& d) { d.close();
//                         }}}, .broken = [](const Door& d) { return d.is_sound() ? "" : "open and locked"; },
//                         .state = [](const Door& d) { return std::string(d.is_open ? "o" : "c"); }};
//   expect_unbroken("door", doors, sequence_depth(8));
//
// A machine that can be copied is copied at each branch. Of others `make` returns a std::unique_ptr, and each
// sequence is played from the beginning.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace bw::test {

template <class Machine>
struct Sequences {
  struct Event {
    std::string name;
    std::function<void(Machine&)> apply;
  };
  using Made = std::conditional_t<std::is_copy_constructible_v<Machine>, Machine, std::unique_ptr<Machine>>;

  std::function<Made()> make;
  std::vector<Event> events;
  /// What is wrong after an event, for people; empty: the invariant holds. An exception of an event breaks it
  /// too.
  std::function<std::string(const Machine&)> broken;
  /// All that decides what the machine does from here on, times as ages; two sequences with the same text are
  /// followed as one.
  /// None: no two sequences are the same.
  std::function<std::string(const Machine&)> state = {};
};

struct Explored {
  int depth = 0;           ///< up to which nothing is broken
  double sequences = 0.0;  ///< of all lengths up to it
  std::uint64_t states = 0, transitions = 0;
  std::string counterexample;  ///< a shortest sequence that breaks the invariant, and how; empty: none
};

/// BANDWAGON_SEQUENCE_DEPTH, else `usual`.
inline int sequence_depth(int usual) {
  const char* wanted = std::getenv("BANDWAGON_SEQUENCE_DEPTH");
  return wanted == nullptr ? usual : std::atoi(wanted);
}

namespace detail {

using Path = std::vector<std::uint16_t>;

template <class Machine>
class Explorer {
 public:
  explicit Explorer(const Sequences<Machine>& machines) : machines_(machines) {}

  Explored explore(int depth) {
    std::vector<Node> level;
    if constexpr (kIsCopied) {
      level.push_back({{}, machines_.make()});
    } else {
      level.push_back({});
    }
    for (int i = 1; i <= depth; ++i) {
      const bool is_last = i == depth;
      std::vector<Node> next;
      for (const Node& node : level) {
        for (std::size_t event = 0; event < machines_.events.size(); ++event) {
          if (!follow(node, event, is_last ? nullptr : &next)) return explored_;
        }
      }
      explored_.depth = i;
      explored_.sequences += std::pow(static_cast<double>(machines_.events.size()), i);
      level = std::move(next);
    }
    return explored_;
  }

 private:
  static constexpr bool kIsCopied = std::is_copy_constructible_v<Machine>;
  struct Nothing {};
  struct Node {
    Path path;
    std::conditional_t<kIsCopied, Machine, Nothing> machine;
  };

  /// False: that broke the invariant.
  bool follow(const Node& node, std::size_t event, std::vector<Node>* next) {
    ++explored_.transitions;
    Path path = node.path;
    path.push_back(static_cast<std::uint16_t>(event));
    if constexpr (kIsCopied) {
      Node after{std::move(path), node.machine};
      if (!happens(after.machine, after.path)) return false;
      if (is_new(after.machine) && next != nullptr) next->push_back(std::move(after));
    } else {
      const std::unique_ptr<Machine> machine = machines_.make();
      for (const std::uint16_t before : node.path) machines_.events[before].apply(*machine);
      if (!happens(*machine, path)) return false;
      if (is_new(*machine) && next != nullptr) next->push_back({std::move(path), {}});
    }
    return true;
  }

  bool happens(Machine& machine, const Path& path) {
    std::string broken;
    try {
      machines_.events[path.back()].apply(machine);
      broken = machines_.broken(machine);
    } catch (const std::exception& error) {
      broken = std::string("exception: ") + error.what();
    }
    if (broken.empty()) return true;
    for (const std::uint16_t event : path) explored_.counterexample += machines_.events[event].name + ", ";
    explored_.counterexample += "then: " + broken;
    return false;
  }

  bool is_new(const Machine& machine) {
    if (machines_.state && !seen_.insert(std::hash<std::string>{}(machines_.state(machine))).second)
      return false;
    ++explored_.states;
    return true;
  }

  const Sequences<Machine>& machines_;
  std::unordered_set<std::uint64_t> seen_;
  Explored explored_;
};

}  // namespace detail

template <class Machine>
Explored explore(const Sequences<Machine>& machines, int depth) {
  return detail::Explorer<Machine>(machines).explore(depth);
}

/// As a test: prints what was looked at, and fails with the sequence.
template <class Machine>
void expect_unbroken(const char* name, const Sequences<Machine>& machines, int depth) {
  const Explored explored = explore(machines, depth);
  std::printf("%s: %zu events, depth %d: %.3g sequences, %llu states, %llu transitions\n", name,
              machines.events.size(), explored.depth, explored.sequences,
              static_cast<unsigned long long>(explored.states),
              static_cast<unsigned long long>(explored.transitions));
  EXPECT_EQ(explored.counterexample, "") << name;
}

}  // namespace bw::test
