#include "components/program/systemd_units.hpp"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "components/program/systemd_hardening.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

/// As a unit's name may have it.
std::string unit_name(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

/// A word of ExecStart=: in quotes, with systemd's own signs taken literally.
std::string quoted(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) {
    if (static_cast<unsigned char>(c) < ' ')
      throw std::runtime_error("--systemd: a unit takes no line breaks: " + word);
    if (c == '"' || c == '\\') text += '\\';
    if (c == '%' || c == '$') text += c;
    text += c;
  }
  return text + '"';
}

std::string command_line(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

/// As a process beyond its memory is killed and started again: the others do not notice.
std::string limits_of(const ProcessLimits& limits) {
  std::string text;
  if (limits.memory) text += fmt::format("MemoryMax={}\nMemorySwapMax=0\nOOMPolicy=kill\n", *limits.memory);
  if (limits.cpu) text += fmt::format("CPUQuota={:g}%\n", 100.0 * *limits.cpu);
  return text;
}

std::string service(const std::string& unit, const std::string& target, const std::string& graph,
                    const SupervisedProgram& program, const ProcessLimits& its_limits) {
  const SupervisionLimits limits;
  return fmt::format(
      "# Written by `bandwagon launch --systemd`, which writes it anew; changes of one's own: systemctl edit.\n"
      "[Unit]\n"
      "Description=Bandwagon: {process} of {graph}\n"
      "Documentation=man:bandwagon(1)\n"
      "PartOf={target}.target\n"
      "After=network.target\n"
      "StartLimitIntervalSec={window:g}\n"
      "StartLimitBurst={starts}\n"
      "# Given up: all of the graph ends, at rest.\n"
      "OnFailure={target}-stop.service\n"
      "\n[Service]\n"
      "Type=notify\n"
      "NotifyAccess=main\n"
      "Environment=XDG_CONFIG_HOME=/etc XDG_STATE_HOME=/var/lib HOME=/var/lib/bandwagon\n"
      "ExecStart={command}\n"
      "WatchdogSec={watchdog}ms\n"
      "WatchdogSignal=SIGKILL\n"
      "Restart=on-failure\n"
      "RestartPreventExitStatus=2\n"
      "RestartSec=200ms\n"
      "TimeoutStartSec={ready:g}\n"
      "TimeoutStopSec={stop:g}\n"
      "KillSignal=SIGTERM\n"
      "KillMode=mixed\n"
      "# What a killed process leaves for the next one: its goal, its pose.\n"
      "RuntimeDirectory={unit}\n"
      "RuntimeDirectoryPreserve=restart\n"
      "{limits}"
      "\n{hardening}",
      fmt::arg("process", program.name), fmt::arg("unit", unit), fmt::arg("graph", graph),
      fmt::arg("target", target), fmt::arg("window", limits.window.to_seconds()),
      fmt::arg("starts", limits.restarts + 1), fmt::arg("command", command_line(program.command(1))),
      fmt::arg("watchdog", limits.watchdog.nanoseconds / 1'000'000),
      fmt::arg("ready", limits.ready.to_seconds()), fmt::arg("stop", limits.stop.to_seconds()),
      fmt::arg("limits", limits_of(its_limits)), fmt::arg("hardening", kSystemdHardening));
}

}  // namespace

void write_units(const std::filesystem::path& folder, const Graph& graph,
                 const std::vector<SupervisedProgram>& programs) {
  const std::string name = graph.path.stem().string();
  const std::string target = "bandwagon-" + unit_name(name);
  const auto write = [&](const std::string& unit, const std::string& text) {
    write_file_atomically(folder / unit, text);
    std::cout << (folder / unit).string() << "\n";
  };
  std::string wants;
  for (const SupervisedProgram& program : programs) {
    const std::string unit = target + "-" + unit_name(program.name);
    const auto limits = graph.limits.find(program.name);
    if (wants.find("=" + unit + ".") != std::string::npos)
      throw std::runtime_error("--systemd: two processes would have the unit " + unit + "; rename one");
    wants += "Wants=" + unit + ".service\n";
    write(unit + ".service", service(unit, target, name, program,
                                     limits == graph.limits.end() ? ProcessLimits{} : limits->second));
  }
  write(target + "-stop.service",
        fmt::format(
            "[Unit]\nDescription=Bandwagon: {} is brought to rest, one of its processes was given up\n\n"
            "[Service]\nType=oneshot\nExecStart=systemctl stop {}.target\n",
            name, target));
  write(target + ".target", fmt::format("[Unit]\nDescription=Bandwagon: all processes of {}\n{}\n[Install]\n"
                                        "WantedBy=multi-user.target\n",
                                        name, wants));
  std::cout << fmt::format(
      "sudo cp {}/{}* /etc/systemd/system && sudo systemctl daemon-reload && sudo systemctl start {}.target\n",
      folder.string(), target, target);
}

}  // namespace bw
