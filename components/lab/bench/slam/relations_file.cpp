#include "components/lab/bench/slam/relations_file.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/import/stamp_text.hpp"
#include "runtime/recording/import/table_reader.hpp"

namespace bw::slam {
namespace {

constexpr std::array kColumns = {"t1", "t2", "x", "y", "z", "roll", "pitch", "yaw"};

class RelationRow {
 public:
  RelationRow(const imports::TableReader& table, const imports::Row& row) : table_(table.name()), row_(row) {
    if (row.cells.size() == kColumns.size()) return;
    throw imports::TableError(
        table_, row.line,
        fmt::format("{} cells where 8 are expected: t1 t2 x y z roll pitch yaw", row.cells.size()));
  }

  Relation read() const {
    for (std::size_t i = 4; i < 7; ++i) number(i);
    return {stamp(0), stamp(1), {number(2), number(3), wrap_angle(number(7))}};
  }

 private:
  Time stamp(std::size_t i) const {
    const auto since_zero = imports::stamp_of_text(row_.cells[i], "s");
    if (!since_zero) refuse(i, "is no stamp in s");
    return Time{} + *since_zero;
  }
  double number(std::size_t i) const {
    const auto value = parse_number(row_.cells[i]);
    if (!value || !std::isfinite(*value)) refuse(i, "is no finite number");
    return *value;
  }
  [[noreturn]] void refuse(std::size_t i, const char* rule) const {
    throw imports::TableError(table_, row_.line, i + 1, kColumns[i], row_.cells[i], rule);
  }

  const std::string& table_;
  const imports::Row& row_;
};

}  // namespace

std::vector<Relation> read_relations(const std::filesystem::path& file) {
  imports::TableReader table(file, {.separator = imports::Separator::whitespace, .comment = "#"});
  std::vector<Relation> relations;
  for (imports::Row row; table.next(row);) relations.push_back(RelationRow(table, row).read());
  if (relations.empty())
    throw std::runtime_error(table.name() + ": no relation in it: lines t1 t2 x y z roll pitch yaw");
  return relations;
}

}  // namespace bw::slam
