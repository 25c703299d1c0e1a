// The learned head that the parameters name.
#pragma once

#include <optional>

#include "components/people/files/head_file.hpp"
#include "components/people/prediction/prediction_options.hpp"
#include "runtime/component.hpp"

namespace bw::people {

/// Nothing unless the model is learned. Throws what read_head() throws.
inline std::optional<HeadWeights> head_of(Setup& setup, const PredictionOptions& options) {
  if (options.model != PredictionModel::learned) return std::nullopt;
  return read_head(setup.file_parameter("prediction.weights").string());
}

}  // namespace bw::people
