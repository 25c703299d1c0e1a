#include "tests/book/human_text.hpp"

#include <algorithm>
#include <cctype>

namespace bw::book {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_alnum(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

void add_line(Passage& passage, std::string_view text, int line) {
  passage.join_with_space(line);
  for (const char c : text) passage.append(c, line);
}

void finish(Passage& passage, std::vector<Passage>& list) {
  if (!passage.text.empty()) list.push_back(std::move(passage));
  passage = {};
}

// Comments and doc texts of C++ and IDL, in one pass over the characters.
class CppReader {
 public:
  explicit CppReader(std::string_view content) : content_(content) {}

  std::vector<Passage> read() {
    while (at_ < content_.size()) {
      const char c = content_[at_];
      if (starts_with("//")) {
        line_comment();
      } else if (starts_with("/*")) {
        block_comment();
      } else if (c == '"') {
        string_literal();
      } else if (c == '\'' && !(at_ > 0 && is_alnum(content_[at_ - 1]))) {
        character_literal();
      } else {
        if (c == '\n') ++line_;
        if (!is_space(c) && c != '\n') code(c);
        ++at_;
      }
    }
    finish(comment_, passages_);
    finish(doc_, passages_);
    return std::move(passages_);
  }

 private:
  bool starts_with(std::string_view text) const { return content_.substr(at_, text.size()) == text; }

  // Code between two comments, or between two literals, parts them.
  void code(char c) {
    finish(comment_, passages_);
    finish(doc_, passages_);
    tail_.push_back(c);
    if (tail_.size() > 5) tail_.erase(0, tail_.size() - 5);
  }

  void line_comment() {
    const std::size_t end = std::min(content_.find('\n', at_), content_.size());
    std::string_view text = content_.substr(at_ + 2, end - at_ - 2);
    while (!text.empty() && (text.front() == '/' || text.front() == '<')) text.remove_prefix(1);
    text = trimmed(text);
    if (text.empty()) {
      finish(comment_, passages_);
    } else {
      add_line(comment_, text, line_);
    }
    at_ = end;
  }

  void block_comment() {
    const std::size_t end = std::min(content_.find("*/", at_ + 2), content_.size());
    std::string_view rest = content_.substr(at_ + 2, end - at_ - 2);
    while (true) {
      const std::size_t line_end = std::min(rest.find('\n'), rest.size());
      std::string_view text = trimmed(rest.substr(0, line_end));
      if (text.starts_with('*')) text = trimmed(text.substr(1));
      if (!text.empty()) add_line(comment_, text, line_);
      if (line_end == rest.size()) break;
      ++line_;
      rest.remove_prefix(line_end + 1);
    }
    at_ = std::min(end + 2, content_.size());
  }

  void character_literal() {
    code('\'');
    for (++at_; at_ < content_.size() && content_[at_] != '\'' && content_[at_] != '\n'; ++at_) {
      if (content_[at_] == '\\') ++at_;
    }
    if (at_ < content_.size() && content_[at_] == '\'') ++at_;
  }

  void string_literal() {
    if (at_ > 0 && content_[at_ - 1] == 'R') {
      raw_literal();
      return;
    }
    // Adjacent literals are one text.
    const bool is_doc = tail_ == ".doc=" || !doc_.text.empty();
    if (!is_doc) code('"');
    for (++at_; at_ < content_.size() && content_[at_] != '"'; ++at_) {
      if (content_[at_] == '\\') ++at_;
      if (at_ < content_.size() && content_[at_] == '\n') ++line_;
      if (is_doc && at_ < content_.size()) doc_.append(content_[at_], line_);
    }
    if (at_ < content_.size()) ++at_;
    if (is_doc) tail_.clear();
  }

  void raw_literal() {
    code('"');
    const std::size_t open = std::min(content_.find('(', at_), content_.size());
    const std::string close = ")" + std::string(content_.substr(at_ + 1, open - at_ - 1)) + "\"";
    const std::size_t end = std::min(content_.find(close, open), content_.size());
    for (; at_ < end; ++at_) {
      if (content_[at_] == '\n') ++line_;
    }
    at_ = std::min(end + close.size(), content_.size());
  }

  std::string_view content_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::string tail_;  // the last characters of code, without spaces
  Passage comment_;
  Passage doc_;
  std::vector<Passage> passages_;
};

std::vector<std::string_view> lines_of(std::string_view content) {
  std::vector<std::string_view> lines;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    lines.push_back(content.substr(0, end));
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return lines;
}

// Where the comment of a line begins: a # at its start or after a space, outside of double quotes.
std::size_t hash_of(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) quoted = !quoted;
    if (line[i] == '#' && !quoted && (i == 0 || is_space(line[i - 1]))) return i;
  }
  return std::string_view::npos;
}

std::vector<Passage> hash_comments(std::string_view content) {
  std::vector<Passage> passages;
  Passage comment;
  int number = 0;
  for (const std::string_view line : lines_of(content)) {
    ++number;
    const std::size_t hash = hash_of(line);
    const bool has_code = !trimmed(line.substr(0, std::min(hash, line.size()))).empty();
    const std::string_view text = hash < line.size() ? trimmed(line.substr(hash + 1)) : std::string_view();
    if (has_code || text.empty()) finish(comment, passages);
    if (!text.empty()) add_line(comment, text, number);
  }
  finish(comment, passages);
  return passages;
}

bool begins_item(std::string_view line) {
  if (line.starts_with('|') || line.starts_with('#') || line.starts_with("- ")) return true;
  std::size_t digits = 0;
  while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) ++digits;
  return digits > 0 && line.substr(digits).starts_with(". ");
}

HumanText markdown(std::string_view content) {
  HumanText result;
  Passage paragraph;
  bool fenced = false;
  int number = 0;
  for (const std::string_view line : lines_of(content)) {
    ++number;
    const std::string_view text = trimmed(line);
    if (text.starts_with("```")) {
      finish(paragraph, result.prose);
      fenced = !fenced;
    } else if (fenced) {
      Passage code;
      add_line(code, line, number);
      finish(code, result.fenced);
    } else {
      if (text.empty() || begins_item(text)) finish(paragraph, result.prose);
      if (!text.empty()) add_line(paragraph, text, number);
    }
  }
  finish(paragraph, result.prose);
  return result;
}

}  // namespace

void Passage::append(char c, int line) {
  text.push_back(c);
  lines.push_back(line);
}

void Passage::join_with_space(int line) {
  if (!text.empty()) append(' ', line);
}

Language language_of(const std::filesystem::path& file) {
  const std::string extension = file.extension();
  if (extension == ".cpp" || extension == ".hpp" || extension == ".idl") return Language::cpp;
  if (extension == ".md") return Language::markdown;
  if (extension == ".cmake" || extension == ".yaml" || extension == ".sh" || extension == ".in" ||
      file.filename() == "CMakeLists.txt")
    return Language::hash;
  return Language::none;
}

HumanText human_text(std::string_view content, Language language) {
  switch (language) {
    case Language::cpp:
      return {CppReader(content).read(), {}};
    case Language::hash:
      return {hash_comments(content), {}};
    case Language::markdown:
      return markdown(content);
    case Language::none:
      break;
  }
  return {};
}

}  // namespace bw::book
