#include "components/tools/experiments/page_parts.hpp"

#include "components/evaluation/svg_writer.hpp"

namespace bw::page {

std::string opening(const std::string& title, int width) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
         "</title><style>\nbody{font-family:sans-serif;max-width:" + std::to_string(width) +
         "em;margin:2em auto;padding:0 1em;color:#222}\n"
         "table{border-collapse:collapse;margin:1em 0}"
         "td,th{padding:.25em .7em;border-bottom:1px solid #ddd;text-align:right}"
         "td:first-child,th:first-child{text-align:left}"
         ".met{color:#187a2f}.not{color:#b3261e;font-weight:bold}</style></head><body>\n";
}

std::string cell(const std::string& html, std::string_view attributes) {
  return "<td" + std::string(attributes) + ">" + html + "</td>";
}

std::string head(std::initializer_list<const char*> names) {
  std::string html = "<table><tr>";
  for (const char* name : names) html += "<th>" + std::string(name) + "</th>";
  return html + "</tr>\n";
}

std::string verdict(bool met) {
  return met ? cell("met", " class=\"met\"") : cell("not met", " class=\"not\"");
}

std::string criteria_table(const std::vector<Criterion>& criteria) {
  std::string html = head({"criterion", "asked", "measured", ""});
  for (const Criterion& c : criteria) {
    html += "<tr>" + cell(xml_text(c.name)) + cell(xml_text(c.asked)) + cell(fixed(c.measured, 4)) +
            verdict(c.met) + "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace bw::page
