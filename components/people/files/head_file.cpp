#include "components/people/files/head_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "components/files/csv_file.hpp"
#include "runtime/base/named_seed.hpp"

namespace bw::people {
namespace {

constexpr const char* kFormat = "bandwagon learned prediction of people, 1";
constexpr Eigen::Index kMostNumbers = 100'000;
constexpr int kWidest = 1'000;  // of a layer

std::string hash_of(const std::string& text) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(named_seed(text, 0)));
  return hash;
}

/// The lines of a file, and where a complaint is of.
class Lines {
 public:
  Lines(const std::string& text, std::string file) : input_(text), file_(std::move(file)) {}

  std::string next() {
    std::string line;
    ++line_;
    if (!std::getline(input_, line)) fail("a line is missing");
    return line;
  }

  std::vector<double> numbers(const std::string& text) const {
    std::vector<double> values;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      double value = 0.0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc{} || end != word.data() + word.size()) fail("`" + word + "` is no number");
      if (!std::isfinite(value)) fail("numbers must be finite");
      values.push_back(value);
    }
    return values;
  }

  Eigen::VectorXd vector(Eigen::Index size) {
    const std::vector<double> values = numbers(next());
    if (static_cast<Eigen::Index>(values.size()) != size)
      fail("it must have " + std::to_string(size) + " numbers");
    return Eigen::Map<const Eigen::VectorXd>(values.data(), size);
  }

  bool at_end() { return input_.peek() == std::istringstream::traits_type::eof(); }
  [[noreturn]] void fail(const std::string& what) const { fail_at(file_, line_, what); }

 private:
  std::istringstream input_;
  std::string file_;
  std::size_t line_ = 0;
};

std::string after(const std::string& line, const std::string& word, const Lines& lines) {
  if (!line.starts_with(word + " ")) lines.fail("it must begin with `" + word + "`");
  return line.substr(word.size() + 1);
}

std::vector<Eigen::Index> read_sizes(Lines& lines) {
  std::vector<Eigen::Index> sizes;
  Eigen::Index numbers = 0;
  for (const double size : lines.numbers(after(lines.next(), "sizes", lines))) {
    if (size < 1.0 || size > kWidest || size != std::floor(size))
      lines.fail("sizes must be whole, from 1 to 1000");
    if (!sizes.empty()) numbers += (sizes.back() + 1) * static_cast<Eigen::Index>(size);
    sizes.push_back(static_cast<Eigen::Index>(size));
  }
  if (sizes.size() < 2 || sizes.front() != kHeadInputs || sizes.back() != kHeadOutputs)
    lines.fail("sizes must lead from " + std::to_string(kHeadInputs) + " to " + std::to_string(kHeadOutputs));
  if (numbers > kMostNumbers) lines.fail("more than 100000 weights");
  return sizes;
}

void write_line(std::ostream& out, const Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%.5g", values[i]);
    out << (i > 0 ? " " : "") << number;
  }
  out << '\n';
}

}  // namespace

HeadWeights read_head(std::istream& input, const std::string& file) {
  const std::string text(std::istreambuf_iterator<char>(input), {});
  Lines lines(text, file);
  if (lines.next() != kFormat) lines.fail(std::string("it must be `") + kFormat + "`");
  const std::string second = lines.next();
  const std::string hash = after(second, "hash", lines);
  const std::string rest = text.substr(std::string(kFormat).size() + second.size() + 2);
  if (hash != hash_of(rest)) lines.fail("the hash of what follows is " + hash_of(rest));
  const std::vector<Eigen::Index> sizes = read_sizes(lines);
  HeadWeights weights;
  weights.mean = lines.vector(kHeadInputs);
  weights.deviation = lines.vector(kHeadInputs);
  if (weights.deviation.minCoeff() <= 0.0) lines.fail("deviations must be above 0");
  for (std::size_t l = 1; l < sizes.size(); ++l) {
    HeadLayer& layer = weights.layers.emplace_back();
    layer.W.resize(sizes[l], sizes[l - 1]);
    layer.b.resize(sizes[l]);
    for (Eigen::Index i = 0; i < sizes[l]; ++i) {
      const Eigen::VectorXd row = lines.vector(sizes[l - 1] + 1);
      layer.W.row(i) = row.head(sizes[l - 1]).transpose();
      layer.b[i] = row[sizes[l - 1]];
    }
  }
  if (!lines.at_end()) lines.fail("nothing may follow");
  return weights;
}

HeadWeights read_head(const std::string& file) {
  std::ifstream input(file);
  if (!input) fail_at(file, 0, "it cannot be read");
  return read_head(input, file);
}

void write_head(std::ostream& out, const HeadWeights& weights) {
  std::ostringstream rest;
  rest << "sizes " << weights.mean.size();
  for (const HeadLayer& layer : weights.layers) rest << ' ' << layer.b.size();
  rest << '\n';
  write_line(rest, weights.mean);
  write_line(rest, weights.deviation);
  for (const HeadLayer& layer : weights.layers) {
    for (Eigen::Index i = 0; i < layer.b.size(); ++i) {
      Eigen::VectorXd row(layer.W.cols() + 1);
      row << layer.W.row(i).transpose(), layer.b[i];
      write_line(rest, row);
    }
  }
  out << kFormat << "\nhash " << hash_of(rest.str()) << '\n' << rest.str();
}

}  // namespace bw::people
