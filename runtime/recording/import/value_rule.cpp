#include "runtime/recording/import/value_rule.hpp"

#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw::imports {
namespace {

/// A number as YAML or as tables write it.
std::optional<double> number_of(const std::string& text) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  if (text == "inf" || text == "+inf") return kInf;
  if (text == "-inf") return -kInf;
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  return parse_number(text);
}

/// Reads the keys of one section.
class RuleReader {
 public:
  RuleReader(const ConfigNode& node, ValueRule& rule, std::vector<Violation>& violations)
      : reader_(node, rule.key, violations), node_(node), rule_(rule), violations_(violations) {}

  void read(bool constant) {
    if (constant) {
      text("value", rule_.value);
    } else {
      text("column", rule_.column);
      text("columns", rule_.columns);
      by_count();
      reader_("of", rule_.of);
      gaps();
      reader_("reverse", rule_.reverse);
      reader_("min", rule_.min);
      reader_("max", rule_.max);
      reader_("no_return_above", rule_.no_return_above);
    }
    reader_("unit", rule_.unit_text);
    const bool has_turning = reader_.find("turning") != nullptr;
    reader_("turning", rule_.turning);
    const bool has_zero = reader_.find("zero") != nullptr;
    reader_("zero", rule_.zero);
    reader_("sigma", rule_.sigma);
    reader_.refuse_unknown_keys();
    check_sources(constant);
    if (rule_.value && rule_.unit_text.empty()) {
      const auto quantity = quantity_of(*rule_.value);
      if (quantity && unit_of(quantity->unit)) rule_.unit_text = quantity->unit;  // else it is a text
    }
    check_unit(has_turning, has_zero);
  }

 private:
  void text(std::string_view name, std::optional<std::string>& value) {
    const ConfigNode* found = reader_.find(name);
    if (found == nullptr) return;
    if (!found->is_scalar()) reader_.refuse(*found, name, "must be one value");
    value = found->scalar;
  }

  void by_count() {
    const ConfigNode* found = reader_.find("by_count");
    if (found == nullptr) return;
    for (const ConfigEntry& entry : found->map) {
      const auto count = parse_integer(entry.key);
      const auto value = number_of(entry.value.scalar);
      if (count && *count >= 0 && value) {
        rule_.by_count.emplace_back(static_cast<std::size_t>(*count), *value);
      } else {
        violations_.push_back({entry.where, rule_.key + ".by_count." + entry.key, entry.value.text(),
                               "must be a count of cells and a number"});
      }
    }
    if (rule_.by_count.empty()) reader_.refuse(*found, "by_count", "must be a section of counts and numbers");
  }

  void gaps() {
    const ConfigNode* found = reader_.find("gaps");
    if (found == nullptr) return;
    if (!found->is_map())
      reader_.refuse(*found, "gaps", "must be a section: the cell's text, and what it means");
    for (const ConfigEntry& entry : found->map) {
      const std::optional<double> value = number_of(entry.value.scalar);
      if (!value && entry.value.scalar != "skip") {
        violations_.push_back({entry.where, rule_.key + ".gaps." + entry.key, entry.value.text(),
                               "must be nan, inf, -inf, a number (SI), or skip (no message from this row)"});
      }
      rule_.gaps.push_back({entry.key, value});
    }
  }

  void check_sources(bool constant) {
    const int count = rule_.column.has_value() + rule_.columns.has_value() + rule_.value.has_value() +
                      !rule_.by_count.empty();
    if (count != 1) {
      violations_.push_back(
          {node_.where, rule_.key, "",
           constant ? "value must be given" : "one of column, columns and by_count must be given"});
    }
    if (rule_.by_count.empty() != rule_.of.empty())
      violations_.push_back(
          {node_.where, rule_.key + ".of", rule_.of, "by_count needs the column whose cells it counts"});
    if (rule_.reverse && !rule_.columns)
      violations_.push_back({node_.where, rule_.key + ".reverse", "true", "is for several columns"});
  }

  void check_unit(bool has_turning, bool has_zero) {
    if (!rule_.unit_text.empty()) {
      const std::optional<Unit> unit = unit_of(rule_.unit_text);
      if (!unit) {
        violations_.push_back({node_.where, rule_.key + ".unit", rule_.unit_text,
                               "unknown unit; known: " + std::string(known_units())});
        return;
      }
      rule_.unit = *unit;
    }
    const bool is_angle = rule_.unit.powers == kAngle;
    if (has_zero && !is_angle)
      violations_.push_back({node_.where, rule_.key + ".zero", std::string(text_of(rule_.zero)),
                             "is for angles: the unit must be one of an angle (rad, deg)"});
    if (has_turning && !is_angle && rule_.unit.powers != kTurnRate)
      violations_.push_back({node_.where, rule_.key + ".turning", std::string(text_of(rule_.turning)),
                             "is for angles and turn rates: the unit must be one of them (rad, deg/s)"});
  }

  ParameterReader reader_;
  const ConfigNode& node_;
  ValueRule& rule_;
  std::vector<Violation>& violations_;
};

}  // namespace

std::optional<Quantity> quantity_of(const std::string& text) {
  const std::size_t blank = text.find(' ');
  const std::optional<double> number = number_of(text.substr(0, blank));
  if (!number) return std::nullopt;
  return Quantity{*number, blank == std::string::npos ? "" : text.substr(text.find_first_not_of(' ', blank))};
}

ValueRule read_value_rule(const ConfigEntry& entry, const std::string& key, bool constant,
                          std::vector<Violation>& violations) {
  ValueRule rule{.where = entry.where, .key = key + "." + entry.key, .field = entry.key};
  ConfigNode section = entry.value;
  if (entry.value.is_scalar()) {  // the short form
    section = {.kind = ConfigNode::Kind::kMap, .where = entry.value.where};
    section.map.push_back({constant ? "value" : "column", entry.where, entry.value});
  }
  if (!section.is_map()) {
    violations.push_back({entry.where, rule.key, entry.value.text(),
                          constant ? "must be a value, or a section" : "must be a column, or a section"});
    return rule;
  }
  RuleReader(section, rule, violations).read(constant);
  return rule;
}

}  // namespace bw::imports
