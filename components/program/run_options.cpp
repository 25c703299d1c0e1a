#include "components/program/run_options.hpp"

#include "runtime/cli/emulate_option.hpp"

namespace bw {

Graph RunOptions::load() const {
  Graph loaded = load_graph(graph, with_emulation(set, emulate));
  record.apply_to(loaded.snapshot);
  page.apply_to(loaded);
  return loaded;
}

void add_run_options(cli::Verb verb, const std::shared_ptr<RunOptions>& options) {
  verb.option("--clock", options->clock,
              "wall, lockstep (virtual time, repeatable) or topic (/clock from outside)")
      .one_of({"wall", "lockstep", "topic"});
  verb.option("--seed", options->seed, "Of everything random");
  verb.option("--set", options->set, "component.param=value, as often as needed").one_each_time();
  verb.flag("--emulate", options->emulate, kEmulateHelp);
  verb.option("--only", options->only, "Only this process of the graph");
  verb.option("--for", options->for_s, "Ends after so many seconds of the component clock").positive();
  verb.option("--pace", options->pace,
              "Lock-step: virtual seconds per real second; 0 as fast as possible (default; with --stay 1)")
      .not_negative();
  verb.flag("--stay", options->stay,
            "Goes on for further goals when one is decided, until --for is over or Ctrl-C");
  verb.flag(
      "--accept-inputs", options->accept_inputs,
      "Lock-step: goals, parameters, transitions and commands of other programs enter the run and its record");
  verb.option("--json", options->json, "Writes the score card here");
  verb.option("--svg", options->svg, "Writes a picture of the run here");
  verb.option("--html", options->html,
              "Writes one page here that plays the drive: a file that needs no server");
  options->record.add_to(verb);
  options->page.add_to(verb);
  verb.flag("--progress", options->progress, "Progress line even when stderr is no terminal");
  verb.flag("--fail-on-contact", options->fail_on_contact, "Exit status 1 after any contact");
}

}  // namespace bw
