#include "components/lab/experiments/first_screen.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace bw {
namespace {

using report::plain;
using report::Tone;

bool is_count(const Criterion& c) {
  return std::isfinite(c.measured) && c.measured == std::round(c.measured) &&
         c.asked.find('.') == std::string::npos;
}

bool is_missed(const Criterion& c) { return !c.met && c.not_judged.empty(); }

/// "All 8 criteria are met." or what is met, what is not and what is open.
std::string count_of(const std::vector<Criterion>& criteria) {
  const auto open = std::ranges::count_if(criteria, [](const Criterion& c) { return !c.not_judged.empty(); });
  const auto judged = std::ssize(criteria) - open;
  const auto met = judged - std::ranges::count_if(criteria, is_missed);
  std::string text;
  if (judged == 0) {
    text = "None of the criteria is judged";
  } else if (met == judged) {
    const char* const which = open > 0 ? "that can be judged " : "";
    text = judged > 1 ? fmt::format("All {} criteria {}are met", judged, which)
                      : fmt::format("The one criterion {}is met", which);
  } else {
    text = fmt::format("{} of {} criteria are met", met, judged);
  }
  if (open > 0)
    text += fmt::format("; {} for more seeds than were run, and {} not judged",
                        open > 1 ? fmt::format("{} ask", open) : "1 asks", open > 1 ? "are" : "is");
  return text + (met < judged ? ". **Not met:**" : ".");
}

}  // namespace

std::string missed_in_words(const Criterion& c) {
  const std::string measured =
      is_count(c) ? fmt::format("{:.0f}", c.measured) : report::in_digits(c.measured);
  return plain(fmt::format("{}: {}, asked {}", c.name, measured, c.asked));
}

report::Table criteria_table(const std::vector<Criterion>& criteria) {
  report::Table table({"criterion", "asked", "measured", "verdict"});
  for (const Criterion& c : criteria) {
    const report::Verdict verdict = !c.not_judged.empty()
                                        ? report::Verdict{"not judged: " + plain(c.not_judged), Tone::open}
                                    : c.met ? report::Verdict{"met", Tone::met}
                                            : report::Verdict{"not met", Tone::missed};
    table.row({plain(c.name), plain(c.asked),
               is_count(c) ? report::Cell(std::lround(c.measured)) : report::Cell(c.measured), verdict});
  }
  return table;
}

report::Document begin_report(const FirstScreen& screen) {
  std::vector<std::string> missed, tuned;
  for (const Criterion& c : screen.criteria)
    if (is_missed(c)) missed.push_back(missed_in_words(c));
  for (const std::string& text : screen.tuned) tuned.push_back(plain(text));
  const bool any_judged =
      std::ranges::any_of(screen.criteria, [](const Criterion& c) { return c.not_judged.empty(); });
  report::Document document(screen.title);
  document.heading(screen.title, 1)
      .text(screen.about)
      .outcome(!any_judged      ? Tone::plain
               : missed.empty() ? Tone::met
                                : Tone::missed,
               {"**Judged: " + plain(screen.judged) + ".** " + count_of(screen.criteria)}, missed)
      .list("**Not judged, or not reproduced:**", screen.not_judged)
      .list(
          "**Chosen with the published values in view, so that agreement shows that they can be had, not that "
          "these were the inputs:**",
          tuned)
      .table(criteria_table(screen.criteria));
  return document;
}

}  // namespace bw
