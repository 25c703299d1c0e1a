#include "components/lab/experiments/page_parts.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "components/evaluation/svg_writer.hpp"

namespace bw::page {
namespace {

constexpr std::string_view kStyle = R"(
*{box-sizing:border-box}
body{font:16px/1.5 system-ui,'Segoe UI','Helvetica Neue',Arial,sans-serif;margin:0 auto;padding:1em;color:#1b2530;background:#fff;overflow-wrap:break-word}
h1{font-size:1.6em;line-height:1.2;margin:.4em 0}h2{margin:1.8em 0 .4em}h3{margin:1.4em 0 .3em}
p,li,figcaption{max-width:50em}a{color:#0b5c94}
.outcome{border:1px solid #c8d0d9;border-left:.4em solid #767676;border-radius:.3em;padding:.2em 1em;margin:1em 0}
.outcome.all{border-left-color:#00795a}.outcome.some{border-left-color:#b34700}
.met{color:#00664c}.open{color:#4a5866}.not{color:#a33c00;font-weight:bold}
table{border-collapse:collapse;margin:1em 0;font-size:.93em;font-variant-numeric:tabular-nums}
td,th{padding:.25em .6em;border-bottom:1px solid #dde2e7;text-align:right;vertical-align:top}
td:first-child,th:first-child,td.text,th.text{text-align:left}
figure{margin:1.6em 0}
.legend{display:flex;flex-wrap:wrap;gap:.1em 1.4em;margin:.5em 0;font-size:.9em}
.legend span{white-space:nowrap}.legend svg{margin-right:.4em;vertical-align:middle}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,21em),1fr));gap:.6em 1em}
.pictures.in1{grid-template-columns:minmax(0,44em)}.pictures.in2{max-width:56em;grid-template-columns:repeat(auto-fill,minmax(min(100%,23em),1fr))}
.pictures>svg{display:block;width:100%;height:auto}
@media screen and (max-width:48em){
thead{display:none}table,tbody{display:block}
tr{display:grid;grid-template-columns:1fr 1fr;gap:0 1em;border-bottom:1px solid #c8d0d9;padding:.5em 0}
td{display:block;border:0;padding:.1em 0;text-align:left}
td:first-child{grid-column:1/-1;font-weight:600}
td[data-is]:not(:first-child)::before{content:attr(data-is);display:block;font-size:.8em;line-height:1.2;color:#4a5866}
td:empty{display:none}
.legend span{white-space:normal}}
@media print{
@page{margin:15mm}
body{font-size:10pt;padding:0;max-width:none!important}
.pictures{grid-template-columns:repeat(2,1fr)}
figure:not(.long),.pictures>svg,tr,.outcome{break-inside:avoid}
h1,h2,h3,figcaption,.legend{break-after:avoid}thead{display:table-header-group}
table{font-size:8.5pt}td,th{padding:.15em .4em}a{color:inherit}}
)";

std::string list(const std::string& lead, const std::vector<std::string>& items) {
  if (items.empty()) return "";
  std::string html = "<p><b>" + lead + "</b></p>\n<ul>\n";
  for (const std::string& item : items) html += "<li>" + item + "</li>\n";
  return html + "</ul>\n";
}

/// "All 8 criteria are met." or what is met, what is not and what is open.
std::string count_of(const std::vector<Criterion>& criteria) {
  const auto count = [&](auto&& is) { return std::count_if(criteria.begin(), criteria.end(), is); };
  const auto open = count([](const Criterion& c) { return !c.not_judged.empty(); });
  const auto met = count([](const Criterion& c) { return c.not_judged.empty() && c.met; });
  const auto judged = static_cast<std::ptrdiff_t>(criteria.size()) - open;
  std::string text;
  if (judged == 0) {
    text = "None of the criteria is judged";
  } else if (met == judged) {
    const std::string which = open > 0 ? "that can be judged " : "";
    text = (judged > 1 ? "All " + std::to_string(judged) + " criteria " + which + "are "
                       : "The one criterion " + which + "is ") +
           "<span class=\"met\">met</span>";
  } else {
    text = std::to_string(met) + " of " + std::to_string(judged) + " criteria are met";
  }
  if (open > 0)
    text += "; " + std::to_string(open) + (open > 1 ? " ask" : " asks") +
            " for more seeds than were run, and " + (open > 1 ? "are" : "is") + " not judged";
  return text + (met < judged ? ". <span class=\"not\">Not met:</span>" : ".");
}

std::string outcome(const FirstScreen& screen) {
  std::string missed;
  bool any_judged = false;
  for (const Criterion& c : screen.criteria) {
    any_judged = any_judged || c.not_judged.empty();
    if (c.met || !c.not_judged.empty()) continue;
    missed += "<li>" + xml_text(c.name) + ": " + sensible(c.measured, c.asked) + ", asked " +
              xml_text(c.asked) + "</li>\n";
  }
  const std::string color = !any_judged ? "" : missed.empty() ? " all" : " some";
  return "<div class=\"outcome" + color + "\">\n<p><b>Judged: " + xml_text(screen.judged) + ".</b> " +
         count_of(screen.criteria) + "</p>\n" + (missed.empty() ? "" : "<ul>\n" + missed + "</ul>\n") +
         "</div>\n";
}

std::string verdict_of(const Criterion& criterion) {
  if (criterion.not_judged.empty()) return verdict(criterion.met);
  return "<span class=\"open\">not judged: " + xml_text(criterion.not_judged) + "</span>";
}

}  // namespace

std::string opening(const std::string& title, int width) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\"><title>" +
         xml_text(title) + "</title><style>" + std::string(kStyle) +
         "body{max-width:" + std::to_string(width) + "em}</style></head><body>\n";
}

std::string closing() { return "</body></html>\n"; }

std::string sensible(double value) {
  if (!std::isfinite(value) || value == 0.0) return fixed(value, 0);
  constexpr int kDigits = 3;
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return fixed(value, std::clamp(kDigits - before_point, 0, 6));
}

std::string sensible(double value, std::string_view like) {
  const bool is_count =
      std::isfinite(value) && value == std::round(value) && like.find('.') == std::string_view::npos;
  return is_count ? fixed(value, 0) : sensible(value);
}

Table::Table(std::vector<std::string> headings)
    : headings_(std::move(headings)), has_text_(headings_.size(), false) {
  for (std::string& heading : headings_) heading = xml_text(heading);
}

void Table::row(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string heading = i < headings_.size() ? headings_[i] : "";
    const bool is_text =
        !cells[i].empty() &&
        (cells[i].front() == '<' || std::isalpha(static_cast<unsigned char>(cells[i].front())) != 0);
    if (is_text && i < has_text_.size()) has_text_[i] = true;
    const char* const look = is_text && i > 0 ? " class=\"text\"" : "";
    rows_ += "<td" + (heading.empty() ? "" : " data-is=\"" + heading + '"') + look + ">" + cells[i] + "</td>";
  }
  rows_ += "</tr>\n";
}

std::string Table::html() const {
  if (rows_.empty()) return "";
  std::string html = "<table><thead><tr>";
  for (std::size_t i = 0; i < headings_.size(); ++i)
    html += (has_text_[i] ? "<th class=\"text\">" : "<th>") + headings_[i] + "</th>";
  return html + "</tr></thead><tbody>\n" + rows_ + "</tbody></table>\n";
}

std::string verdict(bool met) {
  return met ? "<span class=\"met\">met</span>" : "<span class=\"not\">not met</span>";
}

std::string criteria_table(const std::vector<Criterion>& criteria) {
  Table table({"criterion", "asked", "measured", "verdict"});
  for (const Criterion& c : criteria)
    table.row({xml_text(c.name), xml_text(c.asked), sensible(c.measured, c.asked), verdict_of(c)});
  return table.html();
}

std::string first_screen(const FirstScreen& screen) {
  std::vector<std::string> tuned;
  for (const std::string& text : screen.tuned) tuned.push_back(xml_text(text));
  return "<h1>" + xml_text(screen.title) + "</h1>\n<p>" + screen.about + "</p>\n" + outcome(screen) +
         list("Not judged, or not reproduced:", screen.not_judged) +
         list(
             "Chosen with the published values in view, so that agreement shows that they can be had, not that "
             "these were the inputs:",
             tuned) +
         criteria_table(screen.criteria);
}

}  // namespace bw::page
