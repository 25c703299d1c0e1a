// bandwagon reproduce all: every subject in a process of its own, drives in shards, and one page.
#include <algorithm>
#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "components/lab/experiments/all_report.hpp"
#include "components/lab/experiments/reproduce_report.hpp"
#include "components/lab/report/report_page.hpp"
#include "components/lab/shards/child_pool.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/child_process.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

/// CPU seconds on one core of the machine on which they were measured: for the estimate, and to begin with
/// the longest.
struct Cost {
  const char* subject;
  double all, quick;
  bool in_shards;
};
constexpr Cost kCosts[] = {{"eteb", 1100.0, 45.0, true},
                           {"navigation", 640.0, 64.0, true},
                           {"edwa", 95.0, 2.0, false},
                           {"pf", 42.0, 2.0, false},
                           {"ekf", 10.0, 1.0, false}};
constexpr double kAssembly = 5.0;  // of finished drives, and the pages of those that failed
constexpr std::size_t kShardsPerJob = 3;

nlohmann::json read_results(const std::filesystem::path& folder) {
  std::ifstream in(folder / "results.json");
  if (!in || (can_draw_reports() && !std::filesystem::exists(folder / "index.html"))) return nullptr;
  nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  return json.is_object() ? json : nlohmann::json();
}

/// Those that read no file, and so cannot have changed but with the program: the others are put together
/// again from their finished drives.
bool is_kept(const std::string& subject, const ReproduceArguments& arguments) {
  if (subject != "pf" && subject != "edwa") return false;
  const nlohmann::json json = read_results(arguments.out / subject);
  return json.is_object() && json.value("made_by", nlohmann::json()) == nlohmann::json(made_by(arguments));
}

ChildJob job_of(const std::string& subject, const ReproduceArguments& arguments, double cost) {
  const std::filesystem::path folder = arguments.out / subject;
  // The child's own: this program still, when another one has been installed over it.
  ChildJob job{.name = subject,
               .command = {"/proc/self/exe", "reproduce", subject, "--out", folder.string()},
               .log = folder / "log.txt",
               .cost = cost};
  if (arguments.quick) job.command.emplace_back("--quick");
  if (arguments.simulated_drivers && subject == "navigation") job.command.emplace_back("--simulated-drivers");
  return job;
}

std::vector<ChildJob> jobs_of(const ReproduceArguments& arguments) {
  std::vector<ChildJob> jobs;
  const auto add = [&](const Cost& cost) {
    const double seconds = arguments.quick ? cost.quick : cost.all;
    if (!cost.in_shards) {
      if (!is_kept(cost.subject, arguments)) jobs.push_back(job_of(cost.subject, arguments, seconds));
      return;
    }
    const std::size_t shards = static_cast<std::size_t>(arguments.jobs) * kShardsPerJob;
    ChildJob assembly = job_of(cost.subject, arguments, kAssembly);
    for (std::size_t i = 1; i <= shards; ++i) {
      ChildJob shard = job_of(cost.subject, arguments, seconds / static_cast<double>(shards));
      shard.name += fmt::format(" {}/{}", i, shards);
      shard.command.insert(shard.command.end(), {"--shard", fmt::format("{}/{}", i, shards)});
      shard.log.replace_filename(fmt::format("log_{}.txt", i));
      assembly.after.push_back(jobs.size());
      jobs.push_back(std::move(shard));
    }
    jobs.push_back(std::move(assembly));
  };
  for (const Cost& cost : kCosts) add(cost);
  return jobs;
}

/// What stands in the folders now. `statuses` of jobs that ended: 0 and 1 are verdicts, all else is trouble.
AllRun run_now(const ReproduceArguments& arguments, const std::vector<ChildJob>& jobs,
               const std::vector<int>& statuses, bool is_finished) {
  AllRun run{.parts = all_parts(), .quick = arguments.quick, .is_finished = is_finished};
  run.program = fmt::format("bandwagon {} {}", program_version(), source_revision());
  for (AllPart& part : run.parts) {
    nlohmann::json json = read_results(arguments.out / part.subject);
    const bool is_of_now =
        json.is_object() && json.value("made_by", nlohmann::json()) == nlohmann::json(made_by(arguments));
    for (std::size_t i = 0; i < statuses.size(); ++i) {
      const bool is_its = jobs[i].log.parent_path() == arguments.out / part.subject;
      if (is_its && is_finished && statuses[i] > 1)  // of a run that a person ended nothing is wrong
        part.trouble = fmt::format("{} {}: {}/{} ends with what it did; the same command goes on from there",
                                   jobs[i].name, status_in_words(statuses[i]), part.subject,
                                   jobs[i].log.filename().string());
    }
    if (is_of_now && part.trouble.empty()) part.results = std::move(json);
  }
  return run;
}

void write(const AllRun& run, const ReproduceArguments& arguments) {
  write_page(all_page(run), arguments);
  write_file_atomically(arguments.out / "results.json", all_json(run).dump(2) + "\n");
}

std::string minutes(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  return fmt::format("{:.0f} min", seconds / 60.0);
}

void tell(const ChildProgress& p, std::size_t jobs) {
  const std::string about =
      fmt::format("{:3.0f} % after {}{}", 100.0 * p.share, minutes(p.elapsed),
                  p.share > 0.02 && p.share < 1.0 ? ", some " + minutes(p.remaining) + " to go" : "");
  if (p.job == nullptr) {
    std::cerr << about << "\n";
    return;
  }
  const std::string how = p.status == 0   ? "ended"
                          : p.status == 1 ? "ended, not all met"
                                          : fmt::format("FAILED, it {}; {} ends with what it did",
                                                        status_in_words(p.status), p.job->log.string());
  std::cerr << fmt::format("[{}/{}] {}: {}; {}\n", p.ended, jobs, p.job->name, how, about);
}

}  // namespace

bool reproduce_all(const ReproduceArguments& arguments) {
  const std::vector<ChildJob> jobs = jobs_of(arguments);
  cli::catch_interrupts();
  write(run_now(arguments, jobs, {}, false), arguments);
  const std::vector<int> statuses = run_children(jobs, arguments.jobs, cli::interrupted,
                                                 [&](const ChildProgress& p) { tell(p, jobs.size()); });
  const bool is_finished = std::ranges::find(statuses, -1) == statuses.end() && !cli::interrupted();
  const AllRun run = run_now(arguments, jobs, statuses, is_finished);
  write(run, arguments);
  fmt::print("{}{}written: {}\n", all_table(run.parts),
             is_finished ? "" : "interrupted: the same command goes on from here\n",
             (arguments.out / (can_draw_reports() ? "index.html" : "results.json")).string());
  return is_finished && nothing_missed(run.parts);
}

}  // namespace bw
