#include "idl/compiler/lexer.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace bw::idl {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

class Lexer {
 public:
  Lexer(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  std::vector<Token> run() {
    while (skip_blanks(), at_ < text_.size()) {
      if (text_[at_] == '#') {
        directive();
      } else if (is_word(text_[at_])) {
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        add(Token::Type::kWord, text_.substr(begin, at_ - begin));
      } else {
        symbol();
      }
    }
    add(Token::Type::kEnd, "the end of the file");
    return std::move(tokens_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_ + ":" + std::to_string(line_) + ": " + what);
  }

  void add(Token::Type type, std::string_view text) {
    tokens_.push_back({type, std::string(text), line_, std::exchange(comment_, "")});
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_.substr(at_, 2) == "//") {
        at_ = text_.find_first_not_of(' ', at_ + 2);
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        comment_ += std::string(text_.substr(std::min(at_, end), end - std::min(at_, end))) + "\n";
        at_ = end;
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        line_ += text_[at_++] == '\n' ? 1 : 0;
      } else {
        return;
      }
    }
  }

  void directive() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end;
    if (line.starts_with("#include")) {
      const std::size_t open = line.find('"');
      const std::size_t close = line.rfind('"');
      if (open == close) fail("expected #include \"package/msg/Name.idl\"");
      add(Token::Type::kInclude, line.substr(open + 1, close - open - 1));
    } else {
      fail("unknown directive '" + std::string(line) + "'");
    }
  }

  void symbol() {
    const std::size_t length = text_.substr(at_, 2) == "::" ? 2 : 1;
    const std::string_view text = text_.substr(at_, length);
    if (length == 1 && std::string_view("{}[]<>;,=-").find(text) == std::string_view::npos) {
      fail("unexpected '" + std::string(text) + "'");
    }
    add(Token::Type::kSymbol, text);
    at_ += length;
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::string comment_;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, const std::string& path) {
  return Lexer(text, path).run();
}

}  // namespace bw::idl
