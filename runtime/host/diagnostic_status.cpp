#include "runtime/host/diagnostic_status.hpp"

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "runtime/ros/diagnostic_value.hpp"

namespace bw {
namespace {

using diagnostic_msgs::msg::DiagnosticStatus;

void add_location(DiagnosticStatus& status, const Actor& actor) {
  add_value(status, "process", actor.process);
  add_value(status, "lane", actor.lane);
  add_value(status, "latency", fmt::format("{:g} ms", actor.latency.to_seconds() * 1e3));
}

void add_statistics(DiagnosticStatus& status, const CallbackStatistics& s) {
  add_value(status, s.callback,
            fmt::format("calls {} missed {} run p50 {:.3f} p99 {:.3f} max {:.3f} ms wait p50 {:.3f} p99 "
                        "{:.3f} max {:.3f} ms",
                        s.run.count(), s.missed, s.run.quantile_ms(0.5), s.run.quantile_ms(0.99),
                        s.run.max().to_seconds() * 1e3, s.wait.quantile_ms(0.5), s.wait.quantile_ms(0.99),
                        s.wait.max().to_seconds() * 1e3));
}

void add_callbacks(DiagnosticStatus& status, const Actor& actor, bool timings) {
  for (const auto& input : actor.inputs) {
    if (input->statistics.rejected > 0)
      add_value(status, input->name, fmt::format("{} samples rejected", input->statistics.rejected));
    if (timings && input->kind == InputKind::callback) add_statistics(status, input->statistics);
  }
  if (!timings) return;
  for (const auto& timer : actor.timers) add_statistics(status, timer->statistics);
}

std::string age_of(const Input& input, Time now) {
  if (input.statistics.run.count() == 0) return "never";
  // Another lane may have heard it after this look began.
  const double age = std::max(0.0, (now - input.last_received).to_seconds());
  if (!input.max_age) return fmt::format("{:.1f} ms", age * 1e3);
  return fmt::format("{:.1f} ms of {:g} ms", age * 1e3, input.max_age->to_seconds() * 1e3);
}

}  // namespace

void DiagnosticStatuses::add_inputs(DiagnosticStatus& status, const Actor& actor, Time now) {
  for (const auto& input : actor.inputs) {
    if (!input->is_declared) continue;
    add_value(status, "age " + input->topic, age_of(*input, now));
    const Heard heard{input->statistics.run.count(), now};
    const auto [before, is_first] = heard_.try_emplace(input.get(), heard);
    const double passed = (now - before->second.at).to_seconds();
    if (!is_first && passed > 0.0 && heard.samples >= before->second.samples) {
      const auto samples = static_cast<double>(heard.samples - before->second.samples);
      add_value(status, "rate " + input->topic, fmt::format("{:.1f} Hz", samples / passed));
    }
    before->second = heard;
  }
}

DiagnosticStatus DiagnosticStatuses::of(const Actor& actor, Time run_now) {
  const Time now = actor.own_time(run_now);
  const std::lock_guard lock(actor.mutex);
  DiagnosticStatus status;
  status.name(actor.name);
  status.level(static_cast<std::uint8_t>(actor.diagnostic_level));
  status.message(actor.diagnostic_message);
  if (actor.is_in_graph()) add_location(status, actor);
  if (!actor.is_active()) {
    status.level(std::max(status.level(), static_cast<std::uint8_t>(DiagnosticReporter::Level::warn)));
    status.message(std::string(lifecycle::label(actor.state)));
    return status;
  }
  for (const auto& [key, value] : actor.diagnostic_values) add_value(status, key, value);
  for (const Actor::DeclaredFailsafe& failsafe : actor.failsafes) {
    if (failsafe.in_force) add_value(status, "failsafe " + failsafe.row.name, text_of(failsafe.row.action));
  }
  for (const std::string& input : actor.stale_inputs(now)) {
    add_value(status, input, "stale");
    status.level(static_cast<std::uint8_t>(DiagnosticReporter::Level::error));
    status.message("input " + input + " is stale");
  }
  if (actor.is_in_graph()) add_inputs(status, actor, now);
  add_callbacks(status, actor, timings_);
  return status;
}

}  // namespace bw
