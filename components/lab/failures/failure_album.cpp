#include "components/lab/failures/failure_album.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "components/evaluation/svg_writer.hpp"
#include "components/lab/failures/failure_picture.hpp"
#include "components/program/contacts/contact_report.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

constexpr std::size_t kMostLines = 4;  // of contacts in a picture; the page has them all

std::vector<std::string> contact_lines(const FailedDrive& drive) {
  std::vector<std::string> lines;
  for (const nlohmann::ordered_json& contact : to_json(drive.contacts))
    lines.push_back(contact_in_words(contact));
  return lines;
}

/// "turning_walker: 0.84 m off where they headed 2 s before".
std::string in_words(const FoundCause& found) {
  const std::string name = text_of(found.cause);
  if (!found.off_course) return name;
  return name + fmt::format(": {:.2f} m off where they headed 2 s before", *found.off_course);
}

std::string seconds(const std::optional<double>& time) { return time ? fmt::format("{:.1f}", *time) : "-"; }

/// No zero has a sign.
double hundredths(double value) { return std::round(value * 1e2) / 1e2 + 0.0; }

/// One row of the list.
std::string list_row(std::size_t number, const ExplainedFailure& failure) {
  const std::optional<JudgedContact> contact = deciding_contact(failure.drive);
  std::vector<std::string> cells = {failure.drive.outcome, "-", "-", "-", "-", "-"};
  if (contact) {
    const ContactRecord& record = contact->record;
    const auto& verdict = contact->verdict;
    cells = {
        fmt::format("contact at {:.2f} s", record.time),
        fmt::format("{}, person {}", text_of(record.closing.who), record.person),
        fmt::format("{:.2f}, {:.2f}", hundredths(record.closing.robot), hundredths(record.closing.person)),
        contact->is_judged ? possible::text_of(verdict.avoidance) : "not judged",
        seconds(verdict.saveable_until),
        seconds(verdict.lost_since)};
  }
  cells.emplace_back(text_of(failure.cause.cause));
  cells.push_back(failure.cause.off_course ? fmt::format("{:.2f}", *failure.cause.off_course) : "-");
  std::string row = fmt::format("<tr><td>{0}</td><td><a href=\"#d{0}\">{1}</a></td>", number,
                                xml_text(failure.drive.title));
  for (const std::string& cell : cells) row += "<td>" + xml_text(cell) + "</td>";
  return row + "</tr>\n";
}

std::string list_of(const std::vector<ExplainedFailure>& failures) {
  std::string list =
      "<table>\n<tr><th></th><th>drive</th><th>ended</th><th>who hit whom</th><th>closing m/s:<br/>robot, person</th>"
      "<th>verdict</th><th>motion known<br/>until s</th><th>none<br/>from s</th><th>cause</th><th>off<br/>course m</th></tr>\n";
  for (std::size_t i = 0; i < failures.size(); ++i) list += list_row(i + 1, failures[i]);
  return list + "</table>\n";
}

}  // namespace

std::optional<JudgedContact> deciding_contact(const FailedDrive& drive) {
  return drive.contacts.empty() ? std::nullopt : std::optional(drive.contacts.front());
}

std::string causes_in_words(const std::vector<ExplainedFailure>& failures) {
  std::string text;
  for (const FailureCause cause : kAllFailureCauses) {
    const auto count = std::count_if(failures.begin(), failures.end(),
                                     [&](const ExplainedFailure& one) { return one.cause.cause == cause; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, text_of(cause));
  }
  return text.empty() ? "none" : text;
}

std::string failures_page(const std::vector<ExplainedFailure>& failures) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/><title>Failed drives</title>\n<style>\n"
      "body { font: 15px/1.45 'Inter','Segoe UI','Helvetica Neue',Arial,sans-serif; color: #1b2530; margin: 24px auto; "
      "max-width: 1400px; padding: 0 16px; }\n"
      "main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 620px), 1fr)); gap: 24px; }\n"
      ".list { overflow-x: auto; margin: 0 0 24px; }\n"
      "table { border-collapse: collapse; font-size: 14px; font-variant-numeric: tabular-nums; }\n"
      "th, td { text-align: left; padding: 4px 12px 4px 0; border-bottom: 1px solid #e3e8ed; vertical-align: top; white-space: nowrap; }\n"
      "th { color: #5c6b7a; font-weight: 600; }\n"
      "figure { margin: 0; border: 1px solid #c8d0d9; border-radius: 8px; padding: 8px; }\n"
      "img { width: 100%; height: auto; }\nfigcaption { padding: 4px 12px 8px; color: #5c6b7a; }\n"
      "</style></head><body>\n";
  page += fmt::format(
      "<h1>Failed drives: {}</h1>\n<p>Causes: {}. A motion without contact is known from every state of the drive until the first of the "
      "two times, and proven to be none from the second on; seconds since the drive began. Off course: how far who is touched was from "
      "where they headed 2 s before.</p>\n<div class=\"list\">{}</div>\n"
      "<p>Each picture shows the seconds before the contact. Blue: the robot; red: "
      "who is touched; violet: others; dashed green: from the last state of the drive from which a motion "
      "without contact is known, that motion. Numbers are seconds since the drive began.</p>\n<main>\n",
      failures.size(), causes_in_words(failures), list_of(failures));
  for (std::size_t i = 0; i < failures.size(); ++i) {
    const FailedDrive& drive = failures[i].drive;
    const std::string file = xml_text(drive.name + ".svg");
    page += fmt::format(
        "<figure id=\"d{3}\"><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"/></a><figcaption>{3}. {1}: {2}",
        file, xml_text(drive.title), xml_text(drive.outcome), i + 1);
    for (const std::string& line : contact_lines(drive)) page += "<br/>" + xml_text(line);
    page += "<br/>" + xml_text(in_words(failures[i].cause)) + "</figcaption></figure>\n";
  }
  return page + "</main></body></html>\n";
}

void FailureAlbum::add(const FailedDrive& drive, const RunRecording& recording) {
  std::filesystem::create_directories(folder_);
  const std::optional<JudgedContact> deciding = deciding_contact(drive);
  const FoundCause cause =
      cause_of(recording, deciding ? std::optional(deciding->record) : std::nullopt, drive.reached);
  FailurePicture picture{.title = drive.title, .lines = {drive.outcome}, .contact = deciding};
  for (const std::string& line : contact_lines(drive)) picture.lines.push_back(line);
  if (picture.lines.size() > kMostLines + 1) {
    const std::size_t more = picture.lines.size() - kMostLines - 1;
    picture.lines.resize(kMostLines + 1);
    picture.lines.push_back(fmt::format("and {} more", more));
  }
  picture.lines.push_back(in_words(cause));
  write_file_atomically((folder_ / (drive.name + ".svg")).string(), failure_picture(recording, picture));
  failures_.push_back({drive, cause});
  write_file_atomically((folder_ / "index.html").string(), failures_page(failures_));
}

}  // namespace bw
