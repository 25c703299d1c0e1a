// The parts that every page of results shares.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "components/tools/experiments/criterion.hpp"

namespace bw::page {

/// Everything up to the first line of the body. `width` [em].
std::string opening(const std::string& title, int width);

std::string cell(const std::string& html, std::string_view attributes = "");
/// "<table>" and its first row.
std::string head(std::initializer_list<const char*> names);
/// A cell that says "met" or "not met".
std::string verdict(bool met);
std::string criteria_table(const std::vector<Criterion>& criteria);

}  // namespace bw::page
