#include "components/lab/experiments/reproduce_drives.hpp"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/evaluate/suite_report.hpp"
#include "components/lab/experiments/drive_chart.hpp"
#include "components/lab/shards/graph_text.hpp"
#include "components/lab/shards/kept.hpp"
#include "components/program/drive.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

constexpr int kMaxPages = 20;  // of drives that failed: some MB each

/// All that a drive depends on.
std::string made_by(const DriveJob& job) {
  return fmt::format("{}\n{}\nseed {} limit {}\n{}", build_id(), cpu_type(), job.seed, job.time_limit,
                     text_of(job.graph()));
}

DriveSettings settings_of(const DriveJob& job) {
  return {.host = {.clock = ClockMode::lockstep, .seed = static_cast<std::uint64_t>(job.seed), .alone = true},
          .longest = Duration::seconds(job.time_limit)};
}

DriveResult drive_uninterrupted(const DriveJob& job, const DriveSettings& settings) {
  DriveResult result = drive(job.graph(), settings);
  if (cli::interrupted()) throw std::runtime_error("interrupted; the same command goes on from here");
  return result;
}

nlohmann::json driven_now(const DriveJob& job) {
  DriveSettings settings = settings_of(job);
  settings.course = true;
  DriveResult result = drive_uninterrupted(job, settings);
  for (const char* of_the_machine :
       {"callbacks", "robot_path", "planner", "process", "real_time_s", "realtime_factor", "graph"})
    result.json.erase(of_the_machine);
  nlohmann::json course = nlohmann::json::array();
  if (result.course)
    for (const Vector2& p : index_course(*result.course)) course.push_back({p.x(), p.y()});
  return {{"card", std::move(result.json)}, {"course", std::move(course)}};
}

DrivenJob driven_job(const nlohmann::json& piece) {
  DrivenJob driven{.card = piece.at("card")};
  for (const nlohmann::json& p : piece.at("course")) driven.course.emplace_back(p.at(0), p.at(1));
  return driven;
}

/// A drive that failed once more, the same to the byte, and recorded: few fail, so that this costs less than
/// to record them all.
std::string page_of(const DriveJob& job, const Kept& kept, const std::filesystem::path& out) {
  const std::string name = file_name_of(job.title);
  const std::string page = "failed/" + name + ".html";
  const std::string key = made_by(job);
  if (kept.find(name + "_page", key) && std::filesystem::exists(out / page)) return page;
  DriveSettings settings = settings_of(job);
  settings.html = out / page;
  const DriveResult again = drive_uninterrupted(job, settings);
  if (!again.page_fault.empty()) std::cerr << again.page_fault << "\n";
  if (!std::filesystem::exists(settings.html)) return "";
  kept.put(name + "_page", key, page);
  return page;
}

void tell(const DriveJob& job, const nlohmann::json& card, std::size_t done, std::size_t all, bool is_kept) {
  const auto figure = [&](const char* key) {
    const auto found = card.find(key);
    return found != card.end() && found->is_number() ? found->get<double>() : 0.0;
  };
  std::cerr << fmt::format("[{}/{}] {}: {}, largest CI {:.2f}{}\n", done, all, job.title,
                           is_success(card) ? fmt::format("{:.1f} s", figure("time_to_goal_s")) : "FAILED",
                           figure("max_collision_index"), is_kept ? ", kept" : "");
}

}  // namespace

std::vector<DrivenJob> drive_all(const std::vector<DriveJob>& jobs, const ReproduceArguments& arguments) {
  const Kept kept(arguments.out / "kept");
  std::vector<std::string> keys;
  for (const DriveJob& job : jobs)
    keys.push_back(made_by(job));  // a wrong parameter is found before the first drive
  const std::size_t share =
      (jobs.size() + arguments.shard.count - arguments.shard.index) / arguments.shard.count;
  std::vector<DrivenJob> driven;
  cli::catch_interrupts();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!arguments.shard.has(i)) continue;
    const std::string name = file_name_of(jobs[i].title);
    std::optional<nlohmann::json> piece = kept.find(name, keys[i]);
    const bool is_kept = piece.has_value();
    if (!is_kept) {
      std::cerr << jobs[i].title << " ...\n";  // the last line of a process that dies within it
      piece = driven_now(jobs[i]);
      kept.put(name, keys[i], *piece);
    }
    driven.push_back(driven_job(*piece));
    tell(jobs[i], driven.back().card, driven.size(), share, is_kept);
  }
  if (!arguments.shard.is_all()) return {};
  int pages = viewer::page_files().empty() ? kMaxPages : 0;  // of a program without the page none
  for (std::size_t i = 0; i < jobs.size() && pages < kMaxPages; ++i) {
    if (is_success(driven[i].card)) continue;
    driven[i].page = page_of(jobs[i], kept, arguments.out);
    ++pages;
  }
  return driven;
}

std::optional<RunRecording> course_of(const DriveJob& job) {
  DriveSettings settings = settings_of(job);
  settings.course = true;
  return drive_uninterrupted(job, settings).course;
}

}  // namespace bw
