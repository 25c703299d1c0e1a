// The laser's part of the particle filter.
#include <algorithm>
#include <cmath>

#include "components/localization/laser/laser_model.hpp"
#include "components/localization/particle_filter/particle_filter.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kLaserKind = 100;  // no Measurement has this index

Verdict check(const LaserReading& r, std::size_t sources) {
  if (r.source < 0 || static_cast<std::size_t>(r.source) >= sources) return Verdict::bad_source;
  const bool on_robot = r.X_FL.position().norm() <= 100.0;
  return fault_of(r) == SweepFault::none && on_robot ? Verdict::accepted : Verdict::implausible;
}

// The same ends from where the base is now.
BeamEnds seen_from(const Pose2& X_BS, const BeamEnds& ends) {
  BeamEnds moved = ends;
  moved.scanner = X_BS * ends.scanner;
  const auto c = static_cast<float>(std::cos(X_BS.theta));
  const auto s = static_cast<float>(std::sin(X_BS.theta));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    moved.x[i] = static_cast<float>(X_BS.x) + c * ends.x[i] - s * ends.y[i];
    moved.y[i] = static_cast<float>(X_BS.y) + s * ends.x[i] + c * ends.y[i];
  }
  return moved;
}

}  // namespace

void ParticleFilter::set_map(const OccupancyGrid& map) {
  field_.emplace(map, options_.field);
  recovery_.set_field(*field_);
  free_cells_.clear();
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const int value = map.cells[i];
    if (value >= 0 && value < options_.field.kOccupiedAt)
      free_cells_.push_back(static_cast<std::uint32_t>(i));
  }
  map_ = {map.resolution, map.origin, map.width, map.height, {}};
  use_next_sweep_ = true;
}

bool ParticleFilter::start_anywhere(Time time) {
  if (free_cells_.empty()) return false;
  particles_.resize(static_cast<std::size_t>(options_.count.max_particles));
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double index = random_.uniform() * static_cast<double>(free_cells_.size());
    const auto cell =
        static_cast<int>(free_cells_[std::min(static_cast<std::size_t>(index), free_cells_.size() - 1)]);
    const Vector2 centre = map_.center(cell % map_.width, cell / map_.width);
    particles_.x[i] = centre.x() + map_.resolution * (random_.uniform() - 0.5);
    particles_.y[i] = centre.y() + map_.resolution * (random_.uniform() - 0.5);
    particles_.theta[i] = random_.uniform(-std::numbers::pi, std::numbers::pi);
  }
  begin(time, true);
  return true;
}

Outcome ParticleFilter::add(const LaserReading& reading, Time now) {
  const bool jumped = look_at_clock(now);
  Outcome outcome{check(reading, sources_.size())};
  if (outcome.verdict == Verdict::accepted) {
    SourceWatch& watch = source_watch(reading.source);
    if (!watch.is_kind(kLaserKind)) {
      outcome.verdict = Verdict::bad_source;
    } else if (stamps_.in_future(reading.time, now)) {
      outcome.verdict = Verdict::future;
    } else if (!initialised_) {
      laser_heard_ = true;
      outcome.verdict = Verdict::unusable;
    } else if (reading.time < track_.oldest()) {
      outcome.verdict = Verdict::too_old;
    } else if (watch.is_duplicate(reading.time)) {
      outcome.verdict = Verdict::duplicate;
    } else {
      laser_heard_ = true;
      watch.note_seen(reading.time);
      outcome = use(reading);
    }
  }
  outcome.clock_jumped = jumped;
  return noted(outcome);
}

Outcome ParticleFilter::use(const LaserReading& reading) {
  if (!field_) return {Verdict::unusable};
  track_.bridge_silence(reading.time);
  const Pose2 X_OS = track_.at(reading.time);
  const LaserUseOptions& laser = options_.laser;
  const BeamEnds ends = beam_ends(reading, laser.max_beams);
  if (ends.size() == 0) return {Verdict::unusable};
  // The sweep is looked at even if it is not used: a robot that was carried away may stand still.
  recovery_.watch(scan_fit(*field_, ends, estimate_.X_MB * (inverse(X_OB_) * X_OS)), reading.time);
  const std::vector<PoseHypothesis> poses = recovery_.search(ends, X_OS, reading.time);

  const Pose2 moved = inverse(X_OB_last_sweep_) * X_OS;
  const bool far =
      moved.position().norm() >= laser.update_min_d || std::abs(moved.theta) >= laser.update_min_a;
  if (poses.empty() && !far && !use_next_sweep_) return {Verdict::unusable};
  follow();
  ends_ = seen_from(inverse(X_OB_) * X_OS, ends);
  const bool injected = inject(poses, inverse(X_OS) * X_OB_, ends_);
  if (injected) recovery_.injected(reading.time);
  if (!injected && !far && !use_next_sweep_) return {Verdict::unusable};
  log_weight_.assign(particles_.size(), 0.0);
  add_log_weights(*field_, ends_, particles_, log_weight_);
  update_weights();
  if (injected && particles_.size() > static_cast<std::size_t>(options_.count.max_particles)) resample();
  X_OB_last_sweep_ = X_OS;
  use_next_sweep_ = false;
  source_watch(reading.source).note_compared(reading.time, true, 0.0, 0);
  if (recovery_.searching_since() && estimate_.share >= options_.particle_health.kSeveralPlaces &&
      scan_fit(*field_, ends_, estimate_.X_MB).agreement() >= options_.recovery.kScanOk)
    recovery_.found(reading.time);
  return {};
}

// Particles at the poses found, beside those that are there: the sweeps that follow decide between them.
// While a pose is known only poses that agree clearly better count; else all that agree, or all.
bool ParticleFilter::inject(const std::vector<PoseHypothesis>& poses, const Pose2& X_SB,
                            const BeamEnds& ends) {
  if (poses.empty()) return false;
  const RecoveryOptions& o = options_.recovery;
  const bool known = !recovery_.pose_unknown(track_.newest());
  const ScanFit here = scan_fit(*field_, ends, estimate_.X_MB);
  std::vector<Pose2> all;
  std::vector<Pose2> better;
  for (const PoseHypothesis& pose : poses) {
    all.push_back(pose.X_MB * X_SB);
    const ScanFit there = scan_fit(*field_, ends, all.back());
    const bool clearly = there.agreement() > here.agreement() + o.kBetterBy && there.hit > here.hit;
    if (known ? clearly : there.agreement() >= o.kScanOk) better.push_back(all.back());
  }
  if (!known && better.empty()) better.swap(all);
  if (better.empty()) return false;
  const std::size_t before = particles_.size();
  const double share = known ? o.kRivalShare : o.share;
  const std::size_t each =
      std::max<std::size_t>(20, static_cast<std::size_t>(options_.count.max_particles) / better.size());
  particles_.resize(before + each * better.size());
  for (double& w : particles_.weight) w *= 1.0 - share;
  const Eigen::Vector3d variances(o.kSigma * o.kSigma, o.kSigma * o.kSigma,
                                  o.heading_sigma * o.heading_sigma);
  for (std::size_t i = 0; i < better.size(); ++i)
    motion_.scatter(particles_, before + i * each, each, better[i], variances.asDiagonal());
  std::fill(particles_.weight.begin() + static_cast<std::ptrdiff_t>(before), particles_.weight.end(),
            share / static_cast<double>(each * better.size()));
  return true;
}

}  // namespace bw::localization
