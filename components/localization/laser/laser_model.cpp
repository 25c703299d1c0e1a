#include "components/localization/laser/laser_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

// Particles per round: their columns stay in the first cache while all beams pass over them.
constexpr std::size_t kBlock = 1024;

using Column = std::array<float, kBlock>;

struct Block {
  Column column;  // of the particle in the table [cells]
  Column row;
  Column cos;  // [cells per metre]
  Column sin;
  Column sum;
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

// Loops below get what they read and write as plain, unaliased arguments: else they do not vectorise.
BW_VECTOR_CLONES
void to_cells(const double* __restrict metres, double origin, double cells_per_metre, std::size_t count,
              float* __restrict cells) {
  for (std::size_t i = 0; i < count; ++i)
    cells[i] = static_cast<float>((metres[i] - origin) * cells_per_metre);
}

BW_VECTOR_CLONES
void to_directions(const double* __restrict theta, float scale, std::size_t count, float* __restrict cosine,
                   float* __restrict sine) {
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos sin_and_cos = sin_cos(static_cast<float>(theta[i]));
    cosine[i] = sin_and_cos.cos * scale;
    sine[i] = sin_and_cos.sin * scale;
  }
}

// Written so that NaN becomes 0, as the comparisons of the vector units have it.
[[gnu::always_inline]] inline std::int32_t clamped(float value, float last) {
  const float low = value > 0.0F ? value : 0.0F;
  return static_cast<std::int32_t>(low < last ? low : last);
}

struct End {
  float x, y;  // [m] in base_link
};

// Several beams at once: a particle is read, and its sum written, once for all of them.
template <std::size_t kEnds>
[[gnu::always_inline]] inline void add(const Table& table, const End* ends, std::size_t count,
                                       const float* __restrict log_p, const float* __restrict column,
                                       const float* __restrict row, const float* __restrict cosine,
                                       const float* __restrict sine, float* __restrict sum) {
  std::array<End, kEnds> end;
  std::copy_n(ends, kEnds, end.begin());
  for (std::size_t i = 0; i < count; ++i) {
    float of_all = sum[i];
    for (std::size_t b = 0; b < kEnds; ++b) {
      const std::int32_t to_column =
          clamped(column[i] + cosine[i] * end[b].x - sine[i] * end[b].y, table.last_column);
      const std::int32_t to_row = clamped(row[i] + sine[i] * end[b].x + cosine[i] * end[b].y, table.last_row);
      of_all += log_p[to_row * table.width + to_column];
    }
    sum[i] = of_all;
  }
}

BW_VECTOR_CLONES
void add_ends(const Table table, const End* ends, std::size_t beams, std::size_t count,
              const float* __restrict log_p, const float* __restrict column, const float* __restrict row,
              const float* __restrict cosine, const float* __restrict sine, float* __restrict sum) {
  std::size_t b = 0;
  for (; b + 4 <= beams; b += 4) add<4>(table, ends + b, count, log_p, column, row, cosine, sine, sum);
  for (; b < beams; ++b) add<1>(table, ends + b, count, log_p, column, row, cosine, sine, sum);
}

bool goes_through(const LikelihoodField& field, const Vector2& from, const Vector2& to) {
  // Ends about walls, and beams that graze a corner within the error of a good pose, are none.
  constexpr double kBeyond = 0.3;
  const Vector2 beam = to - from;
  const double length = beam.norm() - kBeyond;
  if (!(length > 0.0)) return false;
  const Vector2 along = beam.normalized();
  // No obstacle's cell is nearer than the distance less a cell's diagonal: strides never jump one.
  for (double s = 0.0; s < length;) {
    const Vector2 p = from + s * along;
    const double d = field.distance(p.x(), p.y());
    if (d <= 0.0) return true;
    s += std::max(0.5 * field.resolution(), d - 1.5 * field.resolution());
  }
  return false;
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
  std::vector<End> beams(ends.size());
  for (std::size_t b = 0; b < beams.size(); ++b) beams[b] = {ends.x[b], ends.y[b]};
  Block block;
  for (std::size_t first = 0; first < particles.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, particles.size() - first);
    to_cells(&particles.x[first], table.origin_x, table.cells_per_metre, count, block.column.data());
    to_cells(&particles.y[first], table.origin_y, table.cells_per_metre, count, block.row.data());
    to_directions(&particles.theta[first], static_cast<float>(table.cells_per_metre), count, block.cos.data(),
                  block.sin.data());
    block.sum.fill(0.0F);
    add_ends(table, beams.data(), beams.size(), count, table.log_p, block.column.data(), block.row.data(),
             block.cos.data(), block.sin.data(), block.sum.data());
    for (std::size_t i = 0; i < count; ++i)
      log_weight[first + i] += share * static_cast<double>(block.sum[i]);
  }
}

ScanFit scan_fit(const LikelihoodField& field, const BeamEnds& ends, const Pose2& X_MB) {
  ScanFit fit;
  if (ends.size() == 0) return fit;
  const Vector2 scanner = X_MB * ends.scanner;
  double known = 0.0;
  for (std::size_t b = 0; b < ends.size(); ++b) {
    const Vector2 end = X_MB * Vector2{static_cast<double>(ends.x[b]), static_cast<double>(ends.y[b])};
    if (goes_through(field, scanner, end)) fit.through += 1.0;
    if (!field.known(end.x(), end.y())) continue;
    known += 1.0;
    const double d = field.distance(end.x(), end.y()) / field.options().sigma_hit;
    fit.hit += std::exp(-0.5 * d * d);
  }
  if (known > 0.0) fit.hit /= known;
  fit.known = known / static_cast<double>(ends.size());
  fit.through /= static_cast<double>(ends.size());
  return fit;
}

}  // namespace bw::localization
