#include "components/tools/failures/failure_album.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/evaluation/failure_picture.hpp"
#include "components/evaluation/svg_writer.hpp"
#include "components/tools/contacts/contact_report.hpp"
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

}  // namespace

std::optional<JudgedContact> deciding_contact(const FailedDrive& drive) {
  if (drive.contacts.empty()) return std::nullopt;
  const auto counts = [&](const JudgedContact& contact) {
    return !drive.only_at_speed || contact.record.at_speed;
  };
  const auto found = std::find_if(drive.contacts.begin(), drive.contacts.end(), counts);
  return found == drive.contacts.end() ? drive.contacts.front() : *found;
}

std::string failures_page(const std::vector<FailedDrive>& drives) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>Failed drives</title>\n<style>\n"
      "body { font: 15px/1.45 'Inter','Segoe UI','Helvetica Neue',Arial,sans-serif; color: #1b2530; margin: 24px auto; "
      "max-width: 1400px; padding: 0 16px; }\n"
      "main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 620px), 1fr)); gap: 24px; }\n"
      "figure { margin: 0; border: 1px solid #c8d0d9; border-radius: 8px; padding: 8px; }\n"
      "img { width: 100%; height: auto; }\nfigcaption { padding: 4px 12px 8px; color: #5c6b7a; }\n"
      "</style></head><body>\n";
  page += fmt::format(
      "<h1>Failed drives: {}</h1>\n<p>Each picture shows the seconds before the contact. Blue: the robot; red: "
      "who is touched; violet: others; dashed green: from the last state of the drive from which a motion "
      "without contact is known, that motion. Numbers are seconds since the drive began.</p>\n<main>\n",
      drives.size());
  for (const FailedDrive& drive : drives) {
    const std::string file = xml_text(drive.name + ".svg");
    page += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"/></a><figcaption>{1}: {2}",
        file, xml_text(drive.title), xml_text(drive.outcome));
    for (const std::string& line : contact_lines(drive)) page += "<br/>" + xml_text(line);
    page += "</figcaption></figure>\n";
  }
  return page + "</main></body></html>\n";
}

void FailureAlbum::add(const FailedDrive& drive, const RunRecording& recording) {
  std::filesystem::create_directories(folder_);
  FailurePicture picture{.title = drive.title, .lines = {drive.outcome}, .contact = deciding_contact(drive)};
  for (const std::string& line : contact_lines(drive)) picture.lines.push_back(line);
  if (picture.lines.size() > kMostLines + 1) {
    const std::size_t more = picture.lines.size() - kMostLines - 1;
    picture.lines.resize(kMostLines + 1);
    picture.lines.push_back(fmt::format("and {} more", more));
  }
  write_file_atomically((folder_ / (drive.name + ".svg")).string(), failure_picture(recording, picture));
  drives_.push_back(drive);
  write_file_atomically((folder_ / "index.html").string(), failures_page(drives_));
}

}  // namespace bw
