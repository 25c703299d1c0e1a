#include "components/lab/report/document.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/svg_writer.hpp"
#include "components/lab/report/number_json.hpp"

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Cell::Cell(double value) : json_(Json::object({{"value", number_json(value)}})) {}

Cell::Cell(const std::optional<double>& value)
    : json_(Json::object({{"value", value ? number_json(*value) : Json(nullptr)}})) {}

Cell::Cell(const Interval& interval)
    : json_(Json::object({{"value", number_json(interval.mean)},
                          {"low", number_json(interval.low)},
                          {"high", number_json(interval.high)}})) {}

Cell::Cell(const Verdict& verdict) : json_(Json::object({{"text", verdict.text}, {"tone", verdict.tone}})) {}

Table& Table::row(const std::vector<Cell>& cells) {
  Json row = Json::array();
  for (const Cell& cell : cells) row.push_back(cell.json());
  rows_.push_back(std::move(row));
  return *this;
}

Json Table::json() const {
  Json json = {{"kind", "table"}, {"columns", Json::array()}, {"rows", rows_}};
  for (const Head& head : heads_) {
    json["columns"].push_back({{"name", head.name}});
    if (head.decimals >= 0) json["columns"].back()["decimals"] = head.decimals;
  }
  return json;
}

Document& Document::heading(const std::string& text, int level) {
  blocks_.push_back({{"kind", "heading"}, {"level", level}, {"text", text}});
  return *this;
}

Document& Document::text(const std::string& text) {
  blocks_.push_back({{"kind", "text"}, {"text", text}});
  return *this;
}

Document& Document::list(const std::string& lead, const std::vector<std::string>& items) {
  if (!items.empty()) blocks_.push_back({{"kind", "list"}, {"lead", lead}, {"items", items}});
  return *this;
}

Document& Document::outcome(Tone tone, const std::vector<std::string>& lines,
                            const std::vector<std::string>& missed) {
  blocks_.push_back({{"kind", "outcome"}, {"tone", tone}, {"lines", lines}, {"missed", missed}});
  return *this;
}

Document& Document::table(const Table& table) {
  Json json = table.json();
  if (!json["rows"].empty()) blocks_.push_back(std::move(json));
  return *this;
}

Document& Document::figure(const Figure& figure) {
  if (figure.pictures.empty()) return *this;
  blocks_.push_back({{"kind", "figure"},
                     {"title", figure.title},
                     {"caption", figure.caption},
                     {"columns", figure.columns},
                     {"pictures", figure.pictures}});
  if (!figure.id.empty()) blocks_.back()["id"] = figure.id;
  return *this;
}

Json Document::json() const { return {{"report", 1}, {"title", title_}, {"blocks", blocks_}}; }

std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '*' || c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string in_digits(double value) {
  if (!std::isfinite(value) || value == 0.0) return fixed(value, 0);
  constexpr int kDigits = 3;
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return fixed(value, std::clamp(kDigits - before_point, 0, 6));
}

}  // namespace bw::report
