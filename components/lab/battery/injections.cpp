#include "components/lab/battery/injections.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <thread>

#include <fmt/format.h>

#include "components/lab/battery/injection_bag.hpp"
#include "components/lab/battery/launched.hpp"
#include "components/lab/shards/kept.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/child_process.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

const InjectedProcesses kProcesses{.commander = "planning", .base = "world+base"};
constexpr const char* kWorldApart =
    "--set=world.process=world";  // the base may fail, and what is around it goes on

InjectionPlan plan() {
  InjectionPlan plan{.processes = processes_that_come_back()};
  plan.processes.push_back({.name = kProcesses.base, .component = "motor_control", .leaks = false});
  return plan;
}

bool release_stop(const std::filesystem::path& folder) {
  const std::filesystem::path log = folder / "release.txt";
  ChildProcess call({.command = {robots_program().string(), "service", "call", "/release_stop"}, .log = log});
  while (!call.status()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::ifstream said(log);
  const std::string text{std::istreambuf_iterator<char>(said), {}};
  return text.find("success: true") != std::string::npos;
}

/// To its end; a base that was started again waits for a release, which somebody gives, once for each start.
std::optional<int> follow(Launched& launched, const std::filesystem::path& folder, double patience) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  for (int starts = 2; std::chrono::steady_clock::now() < end;) {
    if (const std::optional<int> status = launched.wait(0.5)) return status;
    if (launched.says(kProcesses.base + " is up after", starts, 0.0) && release_stop(folder)) ++starts;
  }
  return std::nullopt;
}

nlohmann::json number(const std::optional<double>& value) {
  return value ? nlohmann::json(std::round(*value * 1e4) / 1e4) : nlohmann::json();
}

nlohmann::json to_json(const JudgedInjection& one) {
  return {{"kind", one.injection.kind},
          {"process", one.injection.process},
          {"at", one.injection.at},
          {"speed", number(one.speed)},
          {"stop_frame", number(one.stop_frame)},
          {"standing", number(one.standing)},
          {"allowed", number(one.allowed)},
          {"again", number(one.again)},
          {"trouble", one.trouble}};
}

/// The goal, as the last evaluation of the drive saw it.
bool has_reached(const std::filesystem::path& folder) {
  std::ifstream in(folder / "rest.json");
  const nlohmann::json card = nlohmann::json::parse(in, nullptr, false);
  return card.is_object() && card.value("reached", false);
}

nlohmann::json drive_once(const InjectionsOptions& options, std::uint64_t seed, int count) {
  const std::filesystem::path folder = options.out / fmt::format("drive_{}", seed);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::vector<Injection> injections = injections_of(plan(), seed, count);
  std::ofstream(folder / "faults.yaml") << faults_text(injections, plan());
  const std::string bag = (folder / "drive.mcap").string();
  Launched launched(kInjectedGraph,
                    {fmt::format("--seed={}", seed), fmt::format("--for={:g}", options.longest),
                     "--record=" + bag, kWorldApart, "--set=faults=" + (folder / "faults.yaml").string()},
                    folder);
  const std::optional<int> status = follow(launched, folder, options.longest + 60.0);
  nlohmann::json result = {{"seed", seed}, {"status", status.value_or(-1)}};
  InjectedDrive drive;
  try {
    drive = read_injected_drive(bag, injections);
  } catch (const std::runtime_error& error) {
    result["trouble"] = error.what();
  }
  result["reached"] = drive.reached || has_reached(folder);
  result["caused_contacts"] = drive.caused_contacts;
  result["injections"] = nlohmann::json::array();
  for (const JudgedInjection& one : judge(drive, kProcesses)) result["injections"].push_back(to_json(one));
  return result;
}

std::string in_words(const nlohmann::json& drive) {
  std::string text = fmt::format("drive {}: {}{}", drive["seed"].get<std::uint64_t>(),
                                 drive["reached"].get<bool>() ? "goal reached" : "GOAL NOT REACHED",
                                 drive["caused_contacts"] == 0 ? "" : ", CONTACT");
  if (drive.contains("trouble")) text += ": " + drive["trouble"].get<std::string>();
  for (const auto& one : drive["injections"]) {
    const auto shown = [&](const char* key) {
      return one[key].is_null() ? std::string("-") : fmt::format("{:.2f} s", one[key].get<double>());
    };
    text += fmt::format(
        "\n  {:5.1f} s {:16} of {:9} at {:.2f} m/s: stop frame {}, stands {} of {}, drives on {}{}",
        one["at"].get<double>(), one["kind"].get<std::string>(), one["process"].get<std::string>(),
        one["speed"].get<double>(), shown("stop_frame"), shown("standing"), shown("allowed"), shown("again"),
        one["trouble"] == "" ? "" : "; TROUBLE: " + one["trouble"].get<std::string>());
  }
  return text;
}

}  // namespace

InjectionsReport report_of_injections(const nlohmann::json& drives) {
  struct Row {
    int n = 0, failures = 0;
    double frame = 0.0, again = 0.0;
  };
  std::map<std::string, Row> rows;
  int reached = 0, contacts = 0, n = 0, failures = 0;
  double worst_frame = 0.0;
  for (const auto& drive : drives) {
    reached += drive["reached"].get<bool>() ? 1 : 0;
    contacts += drive["caused_contacts"].get<int>();
    for (const auto& one : drive["injections"]) {
      Row& row = rows[one["kind"].get<std::string>() + " of " + one["process"].get<std::string>()];
      ++row.n;
      ++n;
      const bool failed = one["trouble"] != "";
      row.failures += failed ? 1 : 0;
      failures += failed ? 1 : 0;
      if (!one["stop_frame"].is_null()) row.frame = std::max(row.frame, one["stop_frame"].get<double>());
      if (!one["again"].is_null()) row.again = std::max(row.again, one["again"].get<double>());
      worst_frame = std::max(worst_frame, row.frame);
    }
  }
  InjectionsReport report;
  report.text = fmt::format("{:30} {:>5} {:>8} {:>16} {:>14}\n", "injected", "n", "failures",
                            "worst stop frame", "drives on after");
  for (const auto& [name, row] : rows)
    report.text += fmt::format("{:30} {:5} {:8} {:13.0f} ms {:12.1f} s\n", name, row.n, row.failures,
                               1e3 * row.frame, row.again);
  const auto all = static_cast<int>(drives.size());
  report.text += fmt::format("stop frame: worst {:.0f} ms after the last command\n", 1e3 * worst_frame);
  report.text += fmt::format(
      "{} injections in {} drives, {} failures; goal reached without a hand in {}; contacts the "
      "robot caused: {}\n",
      n, all, failures, reached, contacts);
  report.json = {{"n", n},
                 {"drives", all},
                 {"failures", failures + (all - reached) + contacts},
                 {"reached", reached},
                 {"caused_contacts", contacts},
                 {"worst_stop_frame_s", worst_frame}};
  report.is_good = n > 0 && report.json["failures"] == 0;
  return report;
}

InjectionsReport drive_injections(const InjectionsOptions& options) {
  const Kept kept(options.out / "drives");
  const int drives = (options.injections + options.each - 1) / options.each;
  nlohmann::json all = nlohmann::json::array();
  cli::catch_interrupts();
  for (int i = 0; i < drives && !cli::interrupted(); ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    const int count = std::min(options.each, options.injections - i * options.each);
    const std::string name = fmt::format("drive_{}", seed);
    const std::string made_by = fmt::format("{} {} {}", build_id(), count, options.longest);
    std::optional<nlohmann::json> drive = kept.find(name, made_by);
    if (!drive) {
      drive = drive_once(options, seed, count);
      if (cli::interrupted()) break;
      kept.put(name, made_by, *drive);
    }
    std::cout << fmt::format("[{}/{}] {}", i + 1, drives, in_words(*drive)) << std::endl;
    all.push_back(*drive);
  }
  const InjectionsReport report = report_of_injections(all);
  write_file_atomically(options.out / "result.json",
                        nlohmann::ordered_json{{"summary", report.json}, {"drives", all}}.dump(2) + "\n");
  return report;
}

}  // namespace bw
