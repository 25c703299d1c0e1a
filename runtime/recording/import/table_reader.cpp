#include "runtime/recording/import/table_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/bounded_line.hpp"
#include "runtime/recording/import/text_input.hpp"

namespace bw::imports {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Printable start of a text from a file that may hold anything.
std::string excerpt(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text.size() > 40 ? shown + "..." : shown;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

char character_of(Separator separator) {
  switch (separator) {
    case Separator::semicolon:
      return ';';
    case Separator::tab:
      return '\t';
    case Separator::comma:
    case Separator::whitespace:
      break;
  }
  return ',';
}

}  // namespace

TableError::TableError(const std::string& table, std::size_t line, std::size_t column, std::string_view name,
                       std::string_view cell, std::string_view rule)
    : std::runtime_error(fmt::format("{}:{}: column {}{} = '{}': {}", table, line, column,
                                     name.empty() ? "" : " (" + excerpt(name) + ")", excerpt(cell), rule)) {}

TableError::TableError(const std::string& table, std::size_t line, std::string_view rule)
    : std::runtime_error(fmt::format("{}:{}: {}", table, line, rule)) {}

TableReader::TableReader(const std::filesystem::path& file, const TableFormat& format)
    : name_(file.string()), format_(format), input_(open_text(file)) {
  if (!format_.header) return;
  if (!next(header_)) throw TableError(name_, 1, "the header is missing");
}

bool TableReader::next(Row& row) {
  while (read_line(*input_, text_, kLongestLine)) {
    ++line_;
    if (text_.size() > kLongestLine)
      throw TableError(name_, line_, fmt::format("longer than {} characters", kLongestLine));
    std::string_view text = text_;
    if (line_ == 1 && text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (text.ends_with('\r')) text.remove_suffix(1);
    const std::string_view content = trimmed(text);
    const bool is_comment = !format_.comment.empty() && content.starts_with(format_.comment);
    if (content.empty() || is_comment) continue;
    if (format_.separator == Separator::whitespace) text = content;
    row.line = line_;
    split(text, row);
    return true;
  }
  if (input_->bad()) throw std::runtime_error(name_ + ": cannot be read to its end");
  return false;
}

void TableReader::split(std::string_view text, Row& row) const {
  std::size_t count = 0;
  const auto add = [&](std::string_view cell) {
    if (count == row.cells.size()) row.cells.emplace_back();
    row.cells[count++].assign(cell);
  };
  if (format_.separator == Separator::whitespace) {
    for (; !text.empty(); text = trimmed(text)) {
      const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
      add(word);
      text.remove_prefix(word.size());
    }
    row.cells.resize(count);
    return;
  }
  const char separator = character_of(format_.separator);
  for (bool more = true; more;) {
    std::size_t from = text.find_first_not_of(separator == '\t' ? " " : kBlanks);
    std::size_t end = text.find(separator);
    const bool quoted = from != std::string_view::npos && text[from] == '"';
    if (quoted) {
      const std::size_t close = text.find('"', from + 1);
      if (close == std::string_view::npos) throw TableError(name_, row.line, "a quote does not end");
      end = text.find(separator, close);
    }
    std::string_view cell = trimmed(text.substr(0, end));
    if (quoted && cell.size() >= 2 && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    add(cell);
    more = end != std::string_view::npos;
    if (more) text.remove_prefix(end + 1);
  }
  row.cells.resize(count);
}

}  // namespace bw::imports
