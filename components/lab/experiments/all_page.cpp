// The page of all_report.hpp.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "components/evaluation/svg_writer.hpp"
#include "components/lab/experiments/all_report.hpp"
#include "components/lab/experiments/honesty.hpp"
#include "components/lab/experiments/page_parts.hpp"

namespace bw {
namespace {

using page::sensible;
using page::Table;

constexpr std::string_view kLimits =
    "<h2>What this can show, and what not</h2>\n<ul>\n"
    "<li>A published value is one run, or an unknown number of them; what is judged is the distribution over the "
    "seeds.</li>\n"
    "<li>Lengths, places, noises and rates were not published. What is listed as chosen with the published values in "
    "view agrees because it can, not because the inputs were these. What carries evidence are the orderings, contacts "
    "and successes, and the recorded data.</li>\n"
    "<li>E5, E6 and the drives on robots were published as pictures and videos: only orderings, the limit 0.54 of the "
    "collision index and the goal without a contact can be asked for. The drives on robots are drives of emulated "
    "robots in a simulated hallway.</li>\n"
    "<li>Never reproduced here: the variance of the encoders alone in Figure 2.3, which fits no drift that starts at "
    "zero, and the step from the first to the second column of Table 2.1.</li>\n</ul>\n";

std::string link_to(const AllPart& part, const std::string& text) {
  if (!part.results.is_object()) return text;
  return "<a href=\"" + part.subject + "/index.html\">" + text + "</a>";
}

std::string coloured(Verdict verdict) {
  const char* kind = verdict == Verdict::reproduced || verdict == Verdict::in_part ? "met"
                     : verdict == Verdict::not_judged                              ? "open"
                                                                                   : "not";
  return fmt::format("<span class=\"{}\">{}</span>", kind, to_string(verdict));
}

std::string overview(const AllRun& run) {
  Table table({"experiment", "of the source", "verdict", "met", "not met", "not judged"});
  for (const AllPart& part : run.parts) {
    const std::vector<Criterion> criteria = criteria_of(part);
    const auto count = [&](auto is_meant) {
      return std::to_string(std::ranges::count_if(criteria, is_meant));
    };
    table.row({link_to(part, part.experiments), xml_text(part.what), coloured(verdict_of(part)),
               count([](const Criterion& c) { return c.not_judged.empty() && c.met; }),
               count([](const Criterion& c) { return c.not_judged.empty() && !c.met; }),
               count([](const Criterion& c) { return !c.not_judged.empty(); })});
  }
  return table.html();
}

/// "EKF: Figure 2.3, and logs of real robots; Particle filter: Table 2.1": what has this verdict.
std::string named(const AllRun& run, Verdict verdict) {
  std::string names;
  for (const AllPart& part : run.parts)
    if (verdict_of(part) == verdict)
      names += (names.empty() ? "" : "; ") + link_to(part, xml_text(part.what));
  return names;
}

std::string line_of(const AllRun& run, Verdict verdict, const std::string& lead) {
  const std::string names = named(run, verdict);
  return names.empty() ? "" : "<p><b>" + lead + "</b> " + names + ".</p>\n";
}

/// "Reproduced: 3 of 5 ..." and what is missed, by name.
std::string outcome(const AllRun& run) {
  const auto good = std::ranges::count_if(
      run.parts, [](const AllPart& part) { return verdict_of(part) == Verdict::reproduced; });
  std::string missed;
  for (const AllPart& part : run.parts) {
    if (!part.trouble.empty())
      missed += "<li>" + part.experiments + ": " + xml_text(part.trouble) + "</li>\n";
    for (const Criterion& c : criteria_of(part)) {
      if (c.met || !c.not_judged.empty()) continue;
      missed += "<li>" + part.experiments + ", " + xml_text(c.name) + ": " + sensible(c.measured, c.asked) +
                ", asked " + xml_text(c.asked) + "</li>\n";
    }
  }
  const bool is_whole = run.is_finished && std::ranges::none_of(run.parts, [](const AllPart& part) {
                          return part.results.is_null();
                        });
  const char* const colour = !missed.empty() ? " some" : is_whole ? " all" : "";
  std::string html = fmt::format("<div class=\"outcome{}\">\n", colour);
  if (!run.is_finished) html += "<p><b>This run has not ended: the same command goes on from here.</b></p>\n";
  html +=
      run.quick
          ? "<p><b>A quick run: few seeds.</b> What is asked of means, medians and shares is not judged; what must "
            "hold of every run is.</p>\n"
          : (good == 0 ? "<p><b>Nothing is reproduced.</b></p>\n"
                       : line_of(run, Verdict::reproduced,
                                 fmt::format("Reproduced, {} of {}:", good, run.parts.size()))) +
                line_of(run, Verdict::not_reproduced, "Not reproduced:") +
                line_of(run, Verdict::missing, "Without a result:");
  if (!missed.empty()) html += "<p class=\"not\">Not met:</p>\n<ul>\n" + missed + "</ul>\n";
  return html + "</div>\n";
}

double number_of(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>()
                                                   : std::numeric_limits<double>::quiet_NaN();
}

/// "0.0934 (0.081 to 0.11)"; counts where `published` is one.
std::string in_words(const nlohmann::json& spread, const std::string& published) {
  const double low = number_of(spread, "low"), high = number_of(spread, "high");
  std::string text = sensible(number_of(spread, "mean"), published);
  if (low == low && high == high)
    text += " (" + sensible(low, published) + " to " + sensible(high, published) + ")";
  return text;
}

/// "Figure 3.5" is not broken.
std::string in_one_line(const std::string& text) {
  std::string html;
  for (const char c : xml_text(text)) html += c == ' ' ? std::string("&nbsp;") : std::string(1, c);
  return html;
}

std::string published_table(const AllPart& part) {
  Table table({"what", "source", "published", "here", "seeds", "by another reading"});
  for (const nlohmann::json& value : part.results.at("published")) {
    const std::string unit = value.at("unit"), published = value.at("published");
    std::string others;
    for (const nlohmann::json& other : value.at("others")) {
      if (!others.empty()) others += "<br>";
      others += xml_text(other.at("name").get<std::string>()) + ": " + in_words(other, published);
    }
    table.row({xml_text(value.at("what").get<std::string>() + (unit.empty() ? "" : " [" + unit + "]")),
               in_one_line(value.at("source")), xml_text(published), in_words(value.at("here"), published),
               std::to_string(value.at("here").at("seeds").get<int>()), others});
  }
  return table.html();
}

std::string other_readings(const AllPart& part) {
  const nlohmann::json& readings = part.results.at("other_readings");
  if (readings.empty()) return "";
  std::string html = "<p>The same asked of other readings, which decides nothing:</p>\n<ul>\n";
  for (const nlohmann::json& reading : readings) {
    AllPart as_part;
    as_part.results = {{"criteria", reading.at("criteria")}};
    const std::string name = reading.at("name");
    const std::vector<Criterion> criteria = criteria_of(as_part);
    html += "<li>" + xml_text(criteria.empty() ? name + ": not run" : verdict(name, criteria)) + "</li>\n";
  }
  return html + "</ul>\n";
}

std::string tuned(const AllPart& part) {
  std::string html;
  for (const nlohmann::json& text : part.results.at("tuned_to_published"))
    html += "<li>" + xml_text(text.get<std::string>()) + "</li>\n";
  return "<p>Chosen with the published values in view:" +
         (html.empty() ? " nothing.</p>\n" : "</p>\n<ul>\n" + html + "</ul>\n");
}

std::string section(const AllPart& part) {
  std::string html = "<h2>" + part.experiments + ": " + xml_text(part.what) + "</h2>\n";
  if (!part.results.is_object())
    return html + "<p>" + (part.trouble.empty() ? "No result yet." : xml_text(part.trouble)) + "</p>\n";
  return html + "<p>Verdict: " + coloured(verdict_of(part)) +
         ". Judged: " + xml_text(part.results.at("judged").get<std::string>()) + ". " +
         link_to(part, "Figures and all tables") + ".</p>\n" + page::criteria_table(criteria_of(part)) +
         "<h3>Published and here</h3>\n" + published_table(part) + other_readings(part) + tuned(part);
}

}  // namespace

std::string all_page(const AllRun& run) {
  std::string html = page::opening("The dissertation reproduced", 76) +
                     "<h1>The dissertation reproduced</h1>\n" + outcome(run) + overview(run) +
                     "<p>Here: the mean over the seeds, in brackets the 5 % and 95 % quantiles.</p>\n";
  for (const AllPart& part : run.parts) html += section(part);
  return html + std::string(kLimits) + "<p>" + xml_text(run.program) + "</p>\n" + page::closing();
}

}  // namespace bw
