#include "components/emulators/eddie/eddie_command.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace bw::emulators {
namespace {

struct Parameter {
  std::int64_t least = 0, most = 0;
  int signed_bits = 0;  ///< 0: not signed
};

struct Form {
  std::string_view name;
  std::vector<Parameter> parameters;
};

constexpr Parameter kSwitch{0, 1};
constexpr Parameter kPower{-128, 127, 8};
constexpr Parameter kSigned16{-32768, 32767, 16};
constexpr Parameter kUnsigned16{0, 0xFFFF};
constexpr Parameter kPins{0, 0x7FFFF};
constexpr Parameter kSonarPins{0, 0xFFFF};

std::vector<Form> forms(const EddieOptions& options) {
  const bool is_old = options.board == EddieBoard::position_controller;
  const Parameter travel_speed{1, is_old ? 0x7F : 0xFF};
  const Parameter acceleration{1, is_old ? 0xFF : 0x7FF};
  std::vector<Form> known = {{"HWVER", {}},
                             {"VER", {}},
                             {"VERB", {kSwitch}},
                             {"GO", {kPower, kPower}},
                             {"GOSPD", {kSigned16, kSigned16}},
                             {"STOP", {kUnsigned16}},
                             {"TRVL", {kSigned16, travel_speed}},
                             {"TURN", {kSigned16, travel_speed}},
                             {"ACC", {acceleration}},
                             {"SPD", {}},
                             {"DIST", {}},
                             {"HEAD", {}},
                             {"RST", {}},
                             {"PING", {}},
                             {"ADC", {}},
                             {"SPNG", {kSonarPins}},
                             {"SGP", {kPins}},
                             {"INS", {}},
                             {"OUTS", {}},
                             {"LOWS", {}},
                             {"HIGHS", {}},
                             {"READ", {}},
                             {"BLINK", {{0, 18}, kUnsigned16}}};
  for (const std::string_view name : {"IN", "OUT", "LOW", "HIGH"}) known.push_back({name, {kPins}});
  if (options.has_watch) known.push_back({"WATCH", {options.watch_in_seconds ? kUnsigned16 : kSwitch}});
  return known;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t start = text.find_first_not_of(" \t");
    if (start == std::string_view::npos) return words;
    text.remove_prefix(start);
    const std::size_t size = std::min(text.find_first_of(" \t"), text.size());
    words.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
}

std::optional<std::int64_t> number(std::string_view word, const Parameter& parameter) {
  std::uint32_t raw = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), raw, 16);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  std::int64_t value = raw;
  if (const int bits = parameter.signed_bits; bits > 0) {
    const std::int64_t range = std::int64_t{1} << bits;
    if (value >= range) return std::nullopt;
    if (value >= range / 2) value -= range;
  }
  if (value < parameter.least || value > parameter.most) return std::nullopt;
  return value;
}

EddieCommand refusal(std::string reason) { return {.name = {}, .values = {}, .error = std::move(reason)}; }

}  // namespace

EddieCommand parse_line(const EditedLine& line, const EddieOptions& options) {
  if (line.has_overflown) return refusal("Overflow");
  const std::vector<std::string_view> words = words_of(line.text);
  if (words.empty()) return {};
  const std::vector<Form> known = forms(options);
  const auto form = std::ranges::find(known, words.front(), &Form::name);
  if (form == known.end()) return refusal("Invalid command");
  if (words.size() - 1 < form->parameters.size()) return refusal("Too few parameters");
  if (words.size() - 1 > form->parameters.size()) return refusal("Too many parameters");
  EddieCommand command{.name = std::string(words.front()), .values = {}, .error = {}};
  for (std::size_t i = 0; i < form->parameters.size(); ++i) {
    const std::optional<std::int64_t> value = number(words[i + 1], form->parameters[i]);
    if (!value) return refusal("Invalid parameter");
    command.values.push_back(*value);
  }
  return command;
}

}  // namespace bw::emulators
