// bandwagon bag import: a bag of tables.
#pragma once

#include <CLI/App.hpp>

namespace bw::cli {

/// Adds it to the verb `bag`.
void add_bag_import(CLI::App& bag);

}  // namespace bw::cli
