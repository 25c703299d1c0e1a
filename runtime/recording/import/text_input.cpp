#include "runtime/recording/import/text_input.hpp"

#include <array>
#include <stdexcept>
#include <streambuf>
#include <string>

#include <fmt/format.h>
#include <zlib.h>

namespace bw::imports {
namespace {

class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(const std::filesystem::path& file) : name_(file.string()) {
    if (std::filesystem::is_regular_file(file)) file_ = gzopen(file.c_str(), "rbe");
    if (file_ == nullptr) throw std::runtime_error(name_ + ": cannot be read");
  }
  ~TextBuffer() override {
    if (file_ != nullptr) gzclose_r(file_);
  }
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;

 protected:
  int_type underflow() override {
    const int count = gzread(file_, buffer_.data(), static_cast<unsigned>(buffer_.size()));
    int fault = Z_OK;
    std::string what = gzerror(file_, &fault);  // zlib begins it with the name
    if (what.starts_with(name_ + ": ")) what.erase(0, name_.size() + 2);
    // Of data that are cut, zlib first gives what there is, and then tells.
    if (fault == Z_BUF_ERROR) what = "the compressed data end in the middle: the file is cut";
    if (count < 0 || fault == Z_BUF_ERROR)
      throw std::runtime_error(
          fmt::format("{}: byte {}: {}", name_, static_cast<long long>(gzoffset(file_)), what));
    if (count == 0) return traits_type::eof();
    setg(buffer_.data(), buffer_.data(), buffer_.data() + count);
    return traits_type::to_int_type(*gptr());
  }

 private:
  std::string name_;
  gzFile file_ = nullptr;
  std::array<char, 1 << 16> buffer_{};
};

class TextInput : public std::istream {
 public:
  explicit TextInput(const std::filesystem::path& file) : std::istream(nullptr), buffer_(file) {
    rdbuf(&buffer_);
  }

 private:
  TextBuffer buffer_;
};

}  // namespace

std::unique_ptr<std::istream> open_text(const std::filesystem::path& file) {
  return std::make_unique<TextInput>(file);
}

}  // namespace bw::imports
