#include "components/lab/experiments/reproduce.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

struct Subject {
  const char* name;
  const char* what;
  bool (*reproduce)(const ReproduceArguments& arguments);
  bool drives = false;  ///< whole graphs, of which a shard can be driven alone
};

/// A new subject is one line here.
const Subject kSubjects[] = {
    {"ekf", "Figure 2.3: the EKF with wheels, receiver, compass; and on logs of real robots", reproduce_ekf},
    {"pf", "Table 2.1: the particle filter with and without fixes", reproduce_pf},
    {"edwa", "Table 3.2 and Figure 3.4: DWA against EDWA among robots", reproduce_edwa},
    {"pteb",
     "Figures 3.7 and 3.8b: TEB against PTEB among people; judged are the planners by their defaults, not their "
     "published forms",
     reproduce_pteb, true},
    {"eteb",
     "Figures 3.11 and 3.12: TEB, PTEB and ETEB among people; judged are the planners by their defaults, not their "
     "published forms",
     reproduce_eteb, true},
    {"navigation",
     "Figure 3.5 and section 3.4: the whole system on Eddie and QBot 2e; no number is published",
     reproduce_navigation, true},
    {"all", "All of them on one page; a run that was killed goes on where it was", reproduce_all},
};

/// I/N with 1 <= I <= N.
Shard shard_of(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    const bool is_read = second.ec == std::errc() && second.ptr == end;
    if (is_read && shard.index >= 1 && shard.index <= shard.count && shard.count <= 1000) return shard;
  }
  throw std::runtime_error("--shard " + text + ": must be I/N with 1 <= I <= N <= 1000");
}

void add_reproduce(cli::Verb verb) {
  for (const Subject& subject : kSubjects) {
    auto arguments = std::make_shared<ReproduceArguments>();
    cli::Verb one = verb.verb(subject.name, subject.what);
    one.option("--out", arguments->out, "Folder for the page and results.json").required();
    one.flag("--quick", arguments->quick, "Few seeds, only the main rows");
    const std::string_view name = subject.name;
    if (subject.drives)
      one.option_function(
          "--shard", [arguments](const std::string& text) { arguments->shard = shard_of(text); },
          "I/N: only every N-th drive, beginning with the I-th; they are kept in the folder for a run without this option, which "
          "makes the page");
    if (name == "navigation" || name == "all")
      one.flag(
          "--simulated-drivers", arguments->simulated_drivers,
          "navigation: the world turns the wheels and makes the scans, without emulated bases and lasers");
    if (name == "all") {
      arguments->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
      one.option("--jobs", arguments->jobs, "Processes at a time; default: one a core").within(1, 256);
    }
    one.run([&subject, arguments] { return subject.reproduce(*arguments) ? 0 : 1; });
  }
}

}  // namespace

BW_VERB(measure, "reproduce",
        "A table or figure of the dissertation again. Exit status 0: what is judged meets all criteria "
        "(the last lines say what that is), 1: it does not",
        add_reproduce)

}  // namespace bw
