// The parts that every page of results shares: its looks on a screen, a phone and paper, tables, and the first
// screen, which says what was reproduced and what was not.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "components/lab/experiments/criterion.hpp"

namespace bw::page {

/// Everything up to the first line of the body. `width` [em].
std::string opening(const std::string& title, int width);
std::string closing();

/// With three significant digits, none of them after a whole number of four: 37.4, 0.0218, 1520. What is not finite
/// is a dash.
std::string sensible(double value);
/// As sensible(), but a whole number without decimals where none are in `like`, such as "20 of 20": a count.
std::string sensible(double value, std::string_view like);

/// A table whose rows become cards on a narrow screen.
class Table {
 public:
  /// Headings as plain text.
  explicit Table(std::vector<std::string> headings);
  /// Cells as HTML, one for each heading.
  void row(const std::vector<std::string>& cells);
  /// The whole element; empty without a row.
  [[nodiscard]] std::string html() const;

 private:
  std::vector<std::string> headings_;
  std::vector<bool> has_text_;  ///< in some row: such a column stands to the left, heading and all
  std::string rows_;
};

/// "met" or "not met", coloured.
std::string verdict(bool met);
std::string criteria_table(const std::vector<Criterion>& criteria);

struct FirstScreen {
  std::string title;
  std::string about;                     ///< HTML: which parts of the source, what the page shows
  std::string judged;                    ///< what the exit status stands for, as plain text
  std::vector<Criterion> criteria = {};  ///< of what is judged
  std::vector<std::string> not_judged =
      {};                               ///< HTML: what is only reported, or cannot be reproduced, and why
  std::vector<std::string> tuned = {};  ///< plain text: chosen with the published values in view
};

/// Title, what was reproduced and what was not, and the criteria.
std::string first_screen(const FirstScreen& screen);

}  // namespace bw::page
