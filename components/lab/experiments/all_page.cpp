// The report of all_report.hpp.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "components/lab/experiments/all_report.hpp"
#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/first_screen.hpp"

namespace bw {
namespace {

using report::plain;
using report::Tone;

const std::vector<std::string> kWhatItShows = {
    "A published value is one run, or an unknown number of them; what is judged is the distribution over the "
    "seeds.",
    "Lengths, places, noises and rates were not published. What is listed as chosen with the published values in "
    "view agrees because it can, not because the inputs were these. What carries evidence are the orderings, contacts "
    "and successes, and the recorded data.",
    "E5, E6 and the drives on robots were published as pictures and videos: only orderings, the limit 0.54 of the "
    "collision index and the goal without a contact can be asked for. The drives on robots are drives of emulated "
    "robots in a simulated hallway.",
    "Never reproduced here: the variance of the encoders alone in Figure 2.3, which fits no drift that starts at "
    "zero, and the step from the first to the second column of Table 2.1."};

std::string link_to(const AllPart& part, const std::string& text) {
  return part.results.is_object() ? fmt::format("[{}]({}/index.html)", text, part.subject) : text;
}

report::Verdict verdict_cell(const AllPart& part) {
  const Verdict verdict = verdict_of(part);
  return {std::string(to_string(verdict)), verdict == Verdict::reproduced || verdict == Verdict::in_part
                                               ? Tone::met
                                           : verdict == Verdict::not_judged ? Tone::open
                                                                            : Tone::missed};
}

report::Table overview(const AllRun& run) {
  report::Table table({"experiment", "of the source", "verdict", "met", "not met", "not judged"});
  for (const AllPart& part : run.parts) {
    const std::vector<Criterion> criteria = criteria_of(part);
    const auto open =
        std::ranges::count_if(criteria, [](const Criterion& c) { return !c.not_judged.empty(); });
    const auto met =
        std::ranges::count_if(criteria, [](const Criterion& c) { return c.not_judged.empty() && c.met; });
    table.row({link_to(part, part.experiments), plain(part.what), verdict_cell(part), met,
               std::ssize(criteria) - open - met, open});
  }
  return table;
}

/// "**Reproduced, 1 of 5:** EKF: Figure 2.3, and logs of real robots; ...": what has this verdict.
void add_line(std::vector<std::string>& lines, const AllRun& run, Verdict verdict, const std::string& lead) {
  std::string names;
  for (const AllPart& part : run.parts)
    if (verdict_of(part) == verdict) names += (names.empty() ? "" : "; ") + link_to(part, plain(part.what));
  if (!names.empty()) lines.push_back("**" + lead + "** " + names + ".");
}

/// "Reproduced: 3 of 5 ..." and what is missed, by name.
void add_outcome(report::Document& document, const AllRun& run) {
  std::vector<std::string> lines, missed;
  for (const AllPart& part : run.parts) {
    if (!part.trouble.empty()) missed.push_back(part.experiments + ": " + plain(part.trouble));
    for (const Criterion& c : criteria_of(part))
      if (!c.met && c.not_judged.empty()) missed.push_back(part.experiments + ", " + missed_in_words(c));
  }
  const auto good = std::ranges::count(run.parts, Verdict::reproduced, verdict_of);
  const bool is_whole = run.is_finished && std::ranges::none_of(run.parts, [](const AllPart& part) {
                          return part.results.is_null();
                        });
  if (!run.is_finished) lines.emplace_back("**This run has not ended: the same command goes on from here.**");
  if (run.quick) {
    lines.emplace_back(
        "**A quick run: few seeds.** What is asked of means, medians and shares is not judged; what must "
        "hold of every run is.");
  } else {
    if (good == 0) lines.emplace_back("**Nothing is reproduced.**");
    add_line(lines, run, Verdict::reproduced, fmt::format("Reproduced, {} of {}:", good, run.parts.size()));
    add_line(lines, run, Verdict::not_reproduced, "Not reproduced:");
    add_line(lines, run, Verdict::missing, "Without a result:");
  }
  if (!missed.empty()) lines.emplace_back("**Not met:**");
  document.outcome(!missed.empty() ? Tone::missed : is_whole ? Tone::met : Tone::plain, lines, missed);
}

double number_of(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>()
                                                   : std::numeric_limits<double>::quiet_NaN();
}

report::Interval interval(const nlohmann::json& spread) {
  return {number_of(spread, "mean"), number_of(spread, "low"), number_of(spread, "high")};
}

report::Table published_table(const AllPart& part) {
  report::Table table({"what", "source", "published", "here", "seeds", "by another reading"});
  for (const nlohmann::json& value : part.results.at("published")) {
    const std::string unit = value.at("unit");
    std::string others;
    for (const nlohmann::json& other : value.at("others")) {
      const report::Interval i = interval(other);
      others += fmt::format("{}{}: {}", others.empty() ? "" : "; ", plain(other.at("name")),
                            report::in_digits(i.mean));
      if (i.low == i.low && i.high == i.high)
        others += fmt::format(" ({} to {})", report::in_digits(i.low), report::in_digits(i.high));
    }
    table.row({plain(value.at("what").get<std::string>() + (unit.empty() ? "" : " [" + unit + "]")),
               plain(value.at("source")), plain(value.at("published")), interval(value.at("here")),
               value.at("here").at("seeds").get<int>(), others});
  }
  return table;
}

std::vector<std::string> other_readings(const AllPart& part) {
  std::vector<std::string> readings;
  for (const nlohmann::json& reading : part.results.at("other_readings")) {
    AllPart as_part;
    as_part.results = {{"criteria", reading.at("criteria")}};
    const std::string name = reading.at("name");
    const std::vector<Criterion> criteria = criteria_of(as_part);
    readings.push_back(plain(criteria.empty() ? name + ": not run" : verdict(name, criteria)));
  }
  return readings;
}

void add_section(report::Document& document, const AllPart& part) {
  document.heading(part.experiments + ": " + plain(part.what));
  if (!part.results.is_object()) {
    document.text(part.trouble.empty() ? "No result yet." : plain(part.trouble));
    return;
  }
  std::vector<std::string> tuned;
  for (const nlohmann::json& text : part.results.at("tuned_to_published"))
    tuned.push_back(plain(text.get<std::string>()));
  document
      .text(fmt::format("Verdict: {}. Judged: {}. {}.", to_string(verdict_of(part)),
                        plain(part.results.at("judged")), link_to(part, "Figures and all tables")))
      .table(criteria_table(criteria_of(part)))
      .heading("Published and here", 3)
      .table(published_table(part))
      .list("The same asked of other readings, which decides nothing:", other_readings(part));
  if (tuned.empty()) document.text("Chosen with the published values in view: nothing.");
  document.list("Chosen with the published values in view:", tuned);
}

}  // namespace

report::Document all_page(const AllRun& run) {
  report::Document document("The dissertation reproduced");
  document.heading("The dissertation reproduced", 1);
  add_outcome(document, run);
  document.table(overview(run)).text("Here: the mean over the seeds, beside it the 5 % and 95 % quantiles.");
  for (const AllPart& part : run.parts) add_section(document, part);
  document.heading("What this can show, and what not").list("", kWhatItShows).text(plain(run.program));
  return document;
}

}  // namespace bw
