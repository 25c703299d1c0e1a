// A report: titles, paragraphs, tables and figures in the order in which they are read, as one JSON document
// that the page draws (README).
//
// Texts are plain but for **bold** and [words](address); an address is a file beside the report or #id of a
// figure in it.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "components/lab/report/chart.hpp"
#include "components/lab/report/columns.hpp"

namespace bw::report {

/// How something stands to what was asked.
enum class Tone : std::uint8_t { plain, met, open, missed };

NLOHMANN_JSON_SERIALIZE_ENUM(
    Tone, {{Tone::plain, "plain"}, {Tone::met, "met"}, {Tone::open, "open"}, {Tone::missed, "missed"}})

struct Verdict {
  std::string text;
  Tone tone = Tone::plain;
};

/// Text, a count, a figure (three significant digits are shown, or as many decimals as its column says), an
/// interval, a verdict.
class Cell {
 public:
  Cell(std::string text) : json_(std::move(text)) {}
  Cell(std::string_view text) : json_(text) {}
  Cell(const char* text) : json_(text) {}
  Cell(std::integral auto count) : json_(count) {}
  Cell(double value);
  Cell(const std::optional<double>& value);
  Cell(const Interval& interval);
  Cell(const Verdict& verdict);

  [[nodiscard]] const nlohmann::ordered_json& json() const { return json_; }

 private:
  nlohmann::ordered_json json_;
};

/// The head of a column.
struct Head {
  std::string name;   ///< with its unit: "time [s]"
  int decimals = -1;  ///< of figures; below 0: three significant digits

  Head(std::string text, int digits = -1) : name(std::move(text)), decimals(digits) {}
  Head(const char* text, int digits = -1) : name(text), decimals(digits) {}
};

class Table {
 public:
  explicit Table(std::vector<Head> heads) : heads_(std::move(heads)) {}
  /// A cell for each head.
  Table& row(const std::vector<Cell>& cells);
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  std::vector<Head> heads_;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
};

/// Pictures beside one another where there is room, with one legend.
struct Figure {
  std::string title;
  std::string caption = {};  ///< what is shown, and what differs from the source
  int columns = 3;           ///< at most, where there is room: 1 to 3
  std::string id = {};       ///< for links to it
  std::vector<nlohmann::ordered_json> pictures = {};

  void add(const Chart& chart) { pictures.push_back(to_json(chart)); }
  void add(const Columns& all) { pictures.push_back(to_json(all)); }
};

class Document {
 public:
  explicit Document(std::string title) : title_(std::move(title)) {}

  Document& heading(const std::string& text, int level = 2);
  Document& text(const std::string& text);
  /// A list below its lead. Nothing without items.
  Document& list(const std::string& lead, const std::vector<std::string>& items);
  /// A list of what is in a box, as the outcome is.
  Document& outcome(Tone tone, const std::vector<std::string>& lines, const std::vector<std::string>& missed);
  /// Nothing without rows.
  Document& table(const Table& table);
  /// Nothing without pictures.
  Document& figure(const Figure& figure);

  /// {report: 1, title, blocks: [...]}
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  std::string title_;
  nlohmann::ordered_json blocks_ = nlohmann::ordered_json::array();
};

/// Makes a page of a document (report_page.hpp); what is used without a page knows no more of it.
using Writer = std::function<void(const Document& document, const std::filesystem::path& html)>;

/// A text in which nothing is markup.
std::string plain(const std::string& text);

/// As the page shows a figure: with three significant digits, none after a whole number of four. What is not
/// finite is a dash.
std::string in_digits(double value);

}  // namespace bw::report
