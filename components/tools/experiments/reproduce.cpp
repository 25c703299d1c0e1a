#include "components/tools/experiments/reproduce.hpp"

#include <memory>
#include <string_view>

#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

struct Subject {
  const char* name;
  const char* what;
  bool (*reproduce)(const ReproduceArguments& arguments);
};

/// A new subject is one line here.
const Subject kSubjects[] = {
    {"ekf", "Figure 2.3: the EKF with wheels, receiver, compass; and on logs of real robots", reproduce_ekf},
    {"pf", "Table 2.1: the particle filter with and without fixes", reproduce_pf},
    {"edwa", "Table 3.2 and Figure 3.4: DWA against EDWA among robots", reproduce_edwa},
    {"pteb",
     "Figures 3.7 and 3.8b: TEB against PTEB among people; judged are the planners by their defaults, not their "
     "published forms",
     reproduce_pteb},
    {"eteb",
     "Figures 3.11 and 3.12: TEB, PTEB and ETEB among people; judged are the planners by their defaults, not their "
     "published forms",
     reproduce_eteb},
};

CLI::App* add_reproduce(CLI::App& app, int& status) {
  CLI::App* verb =
      app.add_subcommand(
             "reproduce",
             "A table or figure of the dissertation again. Exit status 0: what is judged meets all criteria "
             "(the last lines say what that is), 1: it does not")
          ->require_subcommand(1);
  for (const Subject& subject : kSubjects) {
    auto arguments = std::make_shared<ReproduceArguments>();
    CLI::App* one = verb->add_subcommand(subject.name, subject.what);
    one->add_option("--out", arguments->out, "Folder for the page and results.json")->required();
    one->add_flag("--quick", arguments->quick, "Few seeds, only the main rows");
    one->callback([&subject, arguments, &status] { status = subject.reproduce(*arguments) ? 0 : 1; });
  }
  return verb;
}

}  // namespace

BW_VERB(measure, "reproduce", add_reproduce)

}  // namespace bw
