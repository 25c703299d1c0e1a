#include "components/lab/failures/failure_album.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "components/lab/failures/failure_chart.hpp"
#include "components/program/contacts/contact_report.hpp"

namespace bw {
namespace {

using report::plain;

/// "turning_walker: 0.84 m off where they headed 2 s before".
std::string in_words(const FoundCause& found) {
  const std::string name = text_of(found.cause);
  if (!found.off_course) return name;
  return name + fmt::format(": {:.2f} m off where they headed 2 s before", *found.off_course);
}

std::string seconds(const std::optional<double>& time) { return time ? fmt::format("{:.1f}", *time) : "-"; }

/// No zero has a sign.
double hundredths(double value) { return std::round(value * 1e2) / 1e2 + 0.0; }

std::string id_of(std::size_t number) { return fmt::format("d{}", number); }

/// One row of the list.
std::vector<report::Cell> list_row(std::size_t number, const ExplainedFailure& failure) {
  std::vector<report::Cell> cells = {number,
                                     fmt::format("[{}](#{})", plain(failure.drive.title), id_of(number))};
  if (const std::optional<JudgedContact> contact = deciding_contact(failure.drive)) {
    const ContactRecord& record = contact->record;
    const auto& verdict = contact->verdict;
    cells.insert(cells.end(), {fmt::format("contact at {:.2f} s", record.time),
                               fmt::format("{}, person {}", text_of(record.closing.who), record.person),
                               fmt::format("{:.2f}, {:.2f}", hundredths(record.closing.robot),
                                           hundredths(record.closing.person)),
                               contact->is_judged ? possible::text_of(verdict.avoidance) : "not judged",
                               seconds(verdict.saveable_until), seconds(verdict.lost_since)});
  } else {
    cells.insert(cells.end(), {plain(failure.drive.outcome), "-", "-", "-", "-", "-"});
  }
  cells.emplace_back(text_of(failure.cause.cause));
  cells.emplace_back(failure.cause.off_course ? fmt::format("{:.2f}", *failure.cause.off_course) : "-");
  return cells;
}

report::Figure picture_of(std::size_t number, const ExplainedFailure& failure) {
  std::string words = plain(failure.drive.outcome);
  for (const nlohmann::ordered_json& contact : to_json(failure.drive.contacts))
    words += "; " + plain(contact_in_words(contact));
  report::Figure figure{.title = fmt::format("{}. {}", number, plain(failure.drive.title)),
                        .caption = words + "; " + plain(in_words(failure.cause)),
                        .columns = 1,
                        .id = id_of(number)};
  figure.add(failure.picture);
  return figure;
}

}  // namespace

std::optional<JudgedContact> deciding_contact(const FailedDrive& drive) {
  return drive.contacts.empty() ? std::nullopt : std::optional(drive.contacts.front());
}

std::string causes_in_words(const std::vector<ExplainedFailure>& failures) {
  std::string text;
  for (const FailureCause cause : kAllFailureCauses) {
    const auto count =
        std::ranges::count_if(failures, [&](const auto& one) { return one.cause.cause == cause; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, text_of(cause));
  }
  return text.empty() ? "none" : text;
}

report::Document failures_report(const std::vector<ExplainedFailure>& failures) {
  report::Document document("Failed drives");
  report::Table list({"", "drive", "ended", "who hit whom", "closing m/s: robot, person", "verdict",
                      "motion known until s", "none from s", "cause", "off course m"});
  for (std::size_t i = 0; i < failures.size(); ++i) list.row(list_row(i + 1, failures[i]));
  document.heading(fmt::format("Failed drives: {}", failures.size()), 1)
      .text(fmt::format(
          "Causes: {}. A motion without contact is known from every state of the drive until the first of the "
          "two times, and proven to be none from the second on; seconds since the drive began. Off course: how far who "
          "is touched was from where they headed 2 s before.",
          causes_in_words(failures)))
      .table(list)
      .text(
          "Each picture shows the seconds before the contact; dashed, from the last state of the drive from which a "
          "motion without contact is known, that motion. Numbers are seconds since the drive began.");
  for (std::size_t i = 0; i < failures.size(); ++i) document.figure(picture_of(i + 1, failures[i]));
  return document;
}

void FailureAlbum::add(const FailedDrive& drive, const RunRecording& recording) {
  const std::optional<JudgedContact> deciding = deciding_contact(drive);
  failures_.push_back(
      {drive, cause_of(recording, deciding ? std::optional(deciding->record) : std::nullopt, drive.reached),
       failure_chart(recording, deciding)});
  write_(failures_report(failures_), folder_ / "index.html");
}

}  // namespace bw
