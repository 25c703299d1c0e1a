#include "runtime/recording/import/field_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/import/stamp_text.hpp"
#include "runtime/recording/import/value_rule.hpp"

namespace bw::imports {
namespace {

using Target = MessageDraft::Target;
using Kind = MessageDraft::Kind;

/// A number of a table that breaks a rule; turned into a TableError by who knows the cell.
class BrokenRule : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool is_gap(const Gap& gap, const std::string& cell, const std::optional<double>& number) {
  if (gap.text == cell) return true;
  const std::optional<double> other = parse_number(gap.text);
  return number && other && *number == *other;
}

}  // namespace

void FieldWriter::refuse(const std::string& value, const std::string& why) const {
  throw ConfigError(Violation{rule_.where, rule_.key, value, why});
}

FieldWriter::FieldWriter(const ValueRule& rule, MessageDraft& draft, const ColumnLayout& layout,
                         const std::string& table)
    : rule_(rule) {
  try {
    target_ = draft.find(rule.field);
  } catch (const std::invalid_argument& error) {
    refuse("", error.what());
  }
  check_unit();
  if (rule.value) {
    write_constant(draft);
  } else {
    bind_columns(layout, table);
  }
}

void FieldWriter::check_unit() const {
  if (rule_.unit_text.empty()) return;
  if (target_.kind == Kind::text) refuse(rule_.unit_text, "a text has no unit");
  if (target_.kind == Kind::angle && rule_.unit.powers != kAngle)
    refuse(rule_.unit_text, "must be a unit of an angle: rad, deg");
  if (target_.kind == Kind::time && rule_.unit.powers != kTime)
    refuse(rule_.unit_text, "must be a unit of time: s, ms, us, ns, min, h");
}

void FieldWriter::bind_columns(const ColumnLayout& layout, const std::string& table) {
  const std::string text = rule_.column ? *rule_.column : rule_.columns ? *rule_.columns : rule_.of;
  try {
    if (rule_.column) {
      first_ = last_ = layout.column(text);
    } else {
      std::tie(first_, last_) = layout.columns(text);
    }
  } catch (const std::invalid_argument& error) {
    refuse(text, std::string(error.what()) + ", in " + table);
  }
  if (!rule_.by_count.empty()) {
    if (target_.kind != Kind::number && target_.kind != Kind::angle)
      refuse(text, "a count gives a number only");
    return;
  }
  const bool is_several = rule_.columns.has_value() || layout.is_several(first_);
  if (is_several && target_.kind != Kind::numbers)
    refuse(text, "several cells, where the field is one value");
  if (!is_several && target_.kind == Kind::numbers)
    refuse(text,
           "one cell, where the field is a list: name its columns (columns: first..last), or one element, " +
               rule_.field + "[0]");
}

void FieldWriter::write_constant(MessageDraft& draft) const {
  const std::string& text = *rule_.value;
  std::optional<std::string> rule;
  if (target_.kind == Kind::text) {
    rule = draft.set(target_, std::string_view(text));
  } else if (target_.kind == Kind::time) {
    const auto quantity = quantity_of(text);
    const auto time =
        stamp_of_text(text.substr(0, text.find(' ')), rule_.unit_text.empty() ? "s" : rule_.unit_text);
    if (!quantity || !time) refuse(text, "must be a time");
    rule = draft.set(target_, *time);
  } else if (const auto truth = parse_bool(text)) {
    rule = draft.set(target_, *truth ? 1.0 : 0.0);
  } else {
    const auto quantity = quantity_of(text);
    if (!quantity) refuse(text, "must be a number");
    if (!quantity->unit.empty() && quantity->unit != rule_.unit_text)
      refuse(text, rule_.unit_text.empty() ? "unknown unit; known: " + std::string(known_units())
                                           : "has another unit than `unit`");
    const double value = to_si(quantity->number);
    if (target_.kind == Kind::numbers) {
      const std::size_t count = target_.field->capacity;
      if (target_.field->shape != Shape::kArray)
        refuse(text, "a list of open length has no constant for all");
      rule = draft.set(target_, std::vector<double>(count, value));
    } else {
      rule = draft.set(target_, value);
    }
  }
  if (rule) refuse(text, *rule);
}

double FieldWriter::to_si(double raw) const {
  double value = raw * rule_.unit.scale;
  if (rule_.sigma) return value * value;
  if (rule_.turning == Turning::clockwise) value = -value;
  if (rule_.zero == AngleZero::north) value += std::numbers::pi / 2.0;
  return value;
}

FieldWriter::Number FieldWriter::number_of(const std::string& cell) const {
  std::optional<double> number = parse_number(cell);
  for (const Gap& gap : rule_.gaps) {
    if (is_gap(gap, cell, number)) return {.skips = !gap.value, .value = gap.value.value_or(0.0)};
  }
  if (!number) {
    if (const auto truth = parse_bool(cell)) number = *truth ? 1.0 : 0.0;
  }
  if (!number || !std::isfinite(*number))
    throw BrokenRule("is no finite number; if it means that there is none, list it under gaps");
  if (*number > rule_.no_return_above) return {.value = std::numeric_limits<double>::infinity()};
  if (!(*number >= rule_.min && *number <= rule_.max)) {
    throw BrokenRule(fmt::format("must be between {} and {}{}{}", short_text(rule_.min),
                                 short_text(rule_.max), rule_.unit_text.empty() ? "" : " ", rule_.unit_text));
  }
  return {.value = to_si(*number)};
}

double FieldWriter::by_count(const Row& row, const ColumnLayout& layout, const std::string& table) const {
  const CellRange last = layout.cells(last_);
  const std::size_t count = last.first + last.count - layout.cells(first_).first;
  const auto found = std::ranges::find(rule_.by_count, count, &std::pair<std::size_t, double>::first);
  if (found != rule_.by_count.end()) return to_si(found->second);
  throw TableError(table, row.line,
                   fmt::format("{} cells of '{}': {}:{} gives {} no value for this count", count, rule_.of,
                               rule_.where.file, rule_.where.line, rule_.field));
}

bool FieldWriter::write(const Row& row, const ColumnLayout& layout, const std::string& table,
                        MessageDraft& draft) {
  if (rule_.value) return true;
  if (!rule_.by_count.empty()) {
    if (const auto rule = draft.set(target_, by_count(row, layout, table)))
      throw TableError(table, row.line, *rule);
    return true;
  }
  const std::size_t first = layout.cells(first_).first;
  const std::size_t end = layout.cells(last_).first + layout.cells(last_).count;
  std::size_t cell = first;
  try {
    std::optional<std::string> rule;
    if (target_.kind == Kind::text) {
      rule = draft.set(target_, std::string_view(row.cells[cell]));
    } else if (target_.kind == Kind::time) {
      const auto time = stamp_of_text(row.cells[cell], rule_.unit_text.empty() ? "s" : rule_.unit_text);
      if (!time) throw BrokenRule("is no time");
      rule = draft.set(target_, *time);
    } else {
      values_.clear();
      for (; cell < end; ++cell) {
        const Number number = number_of(row.cells[cell]);
        if (number.skips) return false;
        values_.push_back(number.value);
      }
      cell = first;
      if (rule_.reverse) std::ranges::reverse(values_);
      rule =
          target_.kind == Kind::numbers ? draft.set(target_, values_) : draft.set(target_, values_.front());
    }
    if (rule) throw BrokenRule(*rule);
  } catch (const BrokenRule& broken) {
    throw TableError(table, row.line, cell + 1, layout.name(std::min(first_ + (cell - first), last_)),
                     row.cells[cell], broken.what());
  }
  return true;
}

}  // namespace bw::imports
