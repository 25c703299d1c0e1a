// `bandwagon-lab leaderboard`: results of benches and evaluations as one page.
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/leaderboard/board_page.hpp"
#include "components/lab/leaderboard/board_reader.hpp"
#include "components/lab/leaderboard/gate.hpp"
#include "components/lab/report/report_page.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

void print(const std::vector<BoardSuite>& suites) {
  for (const BoardSuite& suite : suites) {
    std::cout << suite.name << (suite.whole_graph ? ", whole graphs\n" : ", planners alone\n");
    for (const BoardFigures& f : figures_of(suite))
      std::cout << fmt::format("  {} {:<24} {:5.1f} % ({:.1f} to {:.1f}), {} drives from {} starts{}\n",
                               f.wins ? '*' : ' ', f.planner, 100.0 * f.share(), 100.0 * f.success.low,
                               100.0 * f.success.high, f.drives, f.starts,
                               (f.time ? fmt::format(", {:.2f} s", *f.time) : "") +
                                   (f.score ? fmt::format(", score {:.3f}", *f.score) : ""));
  }
  std::cout << "* the best, or not shown to be worse\n";
}

// The exit status.
int hold_to(const GateRecord& before, const GateRecord& now) {
  bool failed = false;
  for (const GateRow& row : compare(before, now)) {
    std::cout << fmt::format("gate: {} {}, {} of {} drives lost and {} won, p {:.3f}{}\n", row.suite,
                             row.planner, row.lost, row.pairs, row.won, row.p, row.failed ? ": WORSE" : "");
    failed |= row.failed;
  }
  return failed ? 1 : 0;
}

void add_leaderboard(cli::Verb verb) {
  struct Options {
    std::vector<std::string> files;
    std::string out;
    std::string json;
    std::string gate;
    std::string write_gate;
  };
  auto options = std::make_shared<Options>();
  verb.option(
          "FILE", options->files,
          "[LABEL:]FILE, results of evaluate or bench (--json); a label stands after the names of its planners")
      .required();
  verb.option("-o,--out", options->out, "The page, one HTML file that needs nothing else");
  verb.option("--json", options->json, "Writes the figures here");
  verb.option("--gate", options->gate,
              "Exit status 1 where drives of this file that succeeded do not any more (McNemar, p < 0.01)")
      .existing_file();
  verb.option("--write-gate", options->write_gate, "Writes that file");
  verb.run([options] {
    if (!options->out.empty()) require_report_page("--out " + options->out);
    std::vector<BoardSuite> suites;
    for (const std::string& file : options->files) {
      const std::size_t colon = file.find(':');  // npos + 1 is 0
      read_board(file.substr(colon + 1), suites, colon == std::string::npos ? "" : file.substr(0, colon));
    }
    print(suites);
    if (!options->out.empty()) write_report_page(board_page(suites), options->out);
    if (!options->json.empty()) write_file_atomically(options->json, to_json(suites).dump(2) + "\n");
    if (!options->write_gate.empty()) write_file_atomically(options->write_gate, to_text(record_of(suites)));
    return options->gate.empty() ? 0 : hold_to(read_gate(options->gate), record_of(suites));
  });
}

}  // namespace

BW_VERB(measure, "leaderboard", "Planners beside each other in several suites, as one page", add_leaderboard)

}  // namespace bw
