// Two messages of one type, field by field.
#pragma once

#include <optional>
#include <string>

#include "runtime/recording/bag/bytes.hpp"
#include "runtime/recording/replay/tolerances.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::replay {

struct FieldDifference {
  std::string field;     ///< with indexes: ranges[17]; a stamp or duration is one field
  std::string recorded;  ///< as text
  std::string replayed;
};

struct MessageDifference {
  std::optional<FieldDifference> first;  ///< beyond its tolerance; nothing: equal
  double largest = 0.0;                  ///< of two numbers of one field that is not left out
  std::string largest_field;
};

/// `type` null: of a type that nobody knows, bytes count.
[[nodiscard]] MessageDifference compare_messages(const TypeDescription* type, bag::BytesView recorded,
                                                 bag::BytesView replayed, const TopicTolerances& tolerances);

}  // namespace bw::replay
