#include "components/localization/laser/laser_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

// Particles per round: their columns stay in the first cache while all beams pass over them.
constexpr std::size_t kBlock = 1024;

struct Block {
  alignas(64) std::array<float, kBlock> column;  // of the particle in the table [cells]
  alignas(64) std::array<float, kBlock> row;
  alignas(64) std::array<float, kBlock> cos;  // [cells per metre]
  alignas(64) std::array<float, kBlock> sin;
  alignas(64) std::array<float, kBlock> sum;
};

struct Table {
  const float* log_p;
  std::int32_t width;
  float last_column;
  float last_row;
  double origin_x;
  double origin_y;
  double cells_per_metre;
};

BW_VECTOR_CLONES
void load(const Table& table, const double* x, const double* y, const double* theta, std::size_t count,
          Block& block) {
  const auto scale = static_cast<float>(table.cells_per_metre);
  for (std::size_t i = 0; i < count; ++i) {
    block.column[i] = static_cast<float>((x[i] - table.origin_x) * table.cells_per_metre);
    block.row[i] = static_cast<float>((y[i] - table.origin_y) * table.cells_per_metre);
    const SinCos turn = sin_cos(static_cast<float>(theta[i]));
    block.cos[i] = turn.cos * scale;
    block.sin[i] = turn.sin * scale;
    block.sum[i] = 0.0F;
  }
}

// Written so that NaN becomes 0, as the comparisons of the vector units have it.
[[gnu::always_inline]] inline std::int32_t clamped(float value, float last) {
  const float low = value > 0.0F ? value : 0.0F;
  return static_cast<std::int32_t>(low < last ? low : last);
}

BW_VECTOR_CLONES
void add_beam(const Table& table, float x, float y, std::size_t count, Block& block) {
  const float* const log_p = table.log_p;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t column =
        clamped(block.column[i] + block.cos[i] * x - block.sin[i] * y, table.last_column);
    const std::int32_t row = clamped(block.row[i] + block.sin[i] * x + block.cos[i] * y, table.last_row);
    block.sum[i] += log_p[row * table.width + column];
  }
}

}  // namespace

void add_log_weights(const LikelihoodField& field, const BeamEnds& ends, const ParticleSet& particles,
                     std::span<double> log_weight) {
  if (ends.size() == 0) return;
  const Table table{field.log_table().data(),
                    field.width(),
                    static_cast<float>(field.width() - 1),
                    static_cast<float>(field.height() - 1),
                    field.origin().x(),
                    field.origin().y(),
                    1.0 / field.resolution()};
  const double share = std::min(1.0, field.options().effective_beams / static_cast<double>(ends.size()));
  Block block;
  for (std::size_t first = 0; first < particles.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, particles.size() - first);
    load(table, &particles.x[first], &particles.y[first], &particles.theta[first], count, block);
    for (std::size_t b = 0; b < ends.size(); ++b) add_beam(table, ends.x[b], ends.y[b], count, block);
    for (std::size_t i = 0; i < count; ++i)
      log_weight[first + i] += share * static_cast<double>(block.sum[i]);
  }
}

ScanFit scan_fit(const LikelihoodField& field, const BeamEnds& ends, const Pose2& X_MB) {
  ScanFit fit;
  if (ends.size() == 0) return fit;
  double known = 0.0;
  for (std::size_t b = 0; b < ends.size(); ++b) {
    const Vector2 end = X_MB * Vector2{static_cast<double>(ends.x[b]), static_cast<double>(ends.y[b])};
    if (!field.known(end.x(), end.y())) continue;
    known += 1.0;
    const double d = field.distance(end.x(), end.y()) / field.options().sigma_hit;
    fit.hit += std::exp(-0.5 * d * d);
  }
  if (known > 0.0) fit.hit /= known;
  fit.known = known / static_cast<double>(ends.size());
  return fit;
}

}  // namespace bw::localization
