#include "components/localization/particle_filter/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/localization/particle_filter/weights.hpp"
#include "components/model/chi_square.hpp"

namespace bw::localization {
namespace {

constexpr double kKnownHeading = 0.0625;  // (0.25 rad)^2: a heading from a path is worth taking
constexpr double kLeastVariance = 1e-9;   // that an answer claims: a set may be one particle many times
constexpr double kAnyHeading = 0.1;       // share of injected particles that look anywhere, without one

}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterOptions& options, std::uint64_t seed, int sources)
    : options_(options),
      random_(seed),
      motion_(random_.bits()),
      track_(options.motion, Duration::seconds(ParticleFilterOptions::kWindow)),
      initial_(options.initial, options.gate.probability),
      stamps_(Duration::seconds(options.kFutureTolerance)),
      sources_(static_cast<std::size_t>(sources)),
      recovery_(options.recovery, options.search) {
  for (int dof = 1; dof <= 3; ++dof) {
    gates_[static_cast<std::size_t>(dof)] = options.gate.enabled
                                                ? chi_square_quantile(options.gate.probability, dof)
                                                : std::numeric_limits<double>::infinity();
  }
}

bool ParticleFilter::start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) {
  PoseReading pose;
  pose.X_MB = X_MB;
  pose.covariance = covariance;
  if (check(pose, options_.limits) != Verdict::accepted) return false;
  particles_.resize(static_cast<std::size_t>(options_.count.max_particles));
  motion_.scatter(particles_, 0, particles_.size(), X_MB, covariance);
  begin(time, false);
  return true;
}

// From particles that have their positions.
void ParticleFilter::begin(Time time, bool anywhere) {
  std::fill(particles_.weight.begin(), particles_.weight.end(), 1.0 / static_cast<double>(particles_.size()));
  track_.restart(time);
  X_OB_ = track_.at(time);
  for (SourceWatch& source : sources_) source.end_run();
  initialised_ = true;
  use_next_sweep_ = true;
  recovery_.restart(anywhere, time);
  effective_size_ = static_cast<double>(particles_.size());
  refresh_estimate();
}

Outcome ParticleFilter::noted(Outcome outcome) {
  ++counts_[static_cast<std::size_t>(outcome.verdict)];
  return outcome;
}

bool ParticleFilter::look_at_clock(Time now) {
  if (!stamps_.clock_went_back(now)) return false;
  stamps_.forget_shift();
  initial_.restart();
  jump_to(now, Duration{});
  return true;
}

// The pose is kept, less sure by the motion that was missed, and goes on from the new time.
void ParticleFilter::jump_to(Time time, Duration missed) {
  last_clock_jump_ = time;
  last_reset_.reset();
  recovery_.move_stamps(time);
  for (SourceWatch& source : sources_) source.move_stamps(time);
  if (!initialised_) return;
  track_.miss(missed);
  follow();
  track_.restart(time);
}

Outcome ParticleFilter::add(const Measurement& measurement, Time now) {
  bool jumped = look_at_clock(now);
  Outcome outcome = sort_in(measurement, now);
  if (const auto* step = std::get_if<WheelStep>(&measurement)) {
    const bool wrong_stamp = outcome.verdict == Verdict::future || outcome.verdict == Verdict::too_old;
    if (stamps_.was_set(*step, wrong_stamp, now)) {
      jump_to(step->time, stamps_.lost());
      jumped = true;
    }
  }
  outcome.clock_jumped = jumped;
  return noted(outcome);
}

Outcome ParticleFilter::sort_in(const Measurement& measurement, Time now) {
  const Verdict sound = check(measurement, options_.limits, static_cast<int>(sources_.size()));
  if (sound != Verdict::accepted) return {sound};
  SourceWatch& watch = source_watch(source(measurement));
  const Time time = stamp(measurement);
  if (!watch.is_kind(measurement.index())) return {Verdict::bad_source};
  if (stamps_.in_future(time, now)) return {Verdict::future};
  if (!initialised_) {
    if (const std::optional<StartPose> start = initial_.add(measurement))
      start_at(start->X_MB, start->covariance, start->time);
    return {Verdict::collected};
  }
  if (time < track_.oldest()) return {Verdict::too_old};
  if (watch.is_duplicate(time)) return {Verdict::duplicate};
  watch.note_seen(time);
  return std::visit([this](const auto& m) { return use(m); }, measurement);
}

Outcome ParticleFilter::use(const WheelStep& step) {
  if (!track_.add(step)) return {Verdict::unusable};
  source_watch(step.source).note_compared(step.time, true, 0.0, 0);
  const UncertainMotion behind = track_.behind();
  if (behind.distance >= options_.motion.longest_distance ||
      behind.rotation >= options_.motion.kLongestRotation)
    follow();
  return {};
}

Outcome ParticleFilter::use(const GyroReading& reading) {
  track_.add(reading);
  source_watch(reading.source).note_compared(reading.time, true, 0.0, 0);
  return {};
}

template <class M>
Outcome ParticleFilter::use(const M& reading) {
  SourceWatch& watch = source_watch(reading.source);
  track_.bridge_silence(reading.time);
  if (std::is_same_v<M, CourseReading> && std::abs(track_.twist().v) < options_.kCourseSpeed)
    return {Verdict::unusable};
  follow();
  const Pose2 X_BS = inverse(X_OB_) * track_.at(reading.time);
  const Comparison c = compare_at(reading, X_BS, track_.twist().v < 0.0);
  constexpr bool kMayTakeOver = !std::is_same_v<M, CourseReading> && !std::is_same_v<M, RangeReading>;
  if (kMayTakeOver) watch.gives(c.position.has_value(), c.heading.has_value());
  differences(c, particles_, differences_);
  Outcome outcome;
  outcome.nis = normalised_innovation(c, particles_, differences_);
  outcome.dof = c.size;
  const bool passes = outcome.nis >= 0.0 && outcome.nis <= gates_[static_cast<std::size_t>(c.size)];
  watch.note_compared(reading.time, passes, outcome.nis, c.size);
  if (!passes) {
    outcome.verdict = Verdict::gated;
    if (!kMayTakeOver || !take_over(c, reading.source, reading.time)) return outcome;
    outcome.verdict = Verdict::reacquired;
    differences(c, particles_, differences_);
  }
  log_weight_.assign(particles_.size(), 0.0);
  add_log_weights(c, differences_, options_.weight_law, log_weight_);
  update_weights();
  return outcome;
}

bool ParticleFilter::supported_by_others(const Comparison& c, int source, const RejectionRun& run) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SourceWatch& other = sources_[i];
    if (static_cast<int>(i) == source || !other.ever_used() || other.last_used() < run.since) continue;
    if (c.position ? other.gives_position() : other.gives_heading()) return true;
    const double driven = track_.odometer() - run.odometer;
    if (!c.position && other.gives_position() && driven >= options_.gate.kHeadingSupport) return true;
  }
  return false;
}

// A source that was rejected for long, in agreement with itself, while nothing else told the same: half of
// the particles go where it says, and the measurement decides between the halves.
bool ParticleFilter::take_over(const Comparison& c, int source, Time time) {
  SourceWatch& watch = source_watch(source);
  const RejectionRun& run =
      watch.note_rejection(c, X_OB_, track_.odometer(), time, gates_[static_cast<std::size_t>(c.size)]);
  const GateOptions& gate = options_.gate;
  if (run.count < gate.kReacquireCount || time - run.since < Duration::seconds(gate.reacquire_after) ||
      supported_by_others(c, source, run))
    return false;
  const double spread = run.fit.spread();
  const double heading_variance = c.position && spread > 0.0 ? std::max(c.R(0, 0), c.R(1, 1)) / spread : 1e9;
  const double from_path = wrap_angle(run.fit.angle() + X_OB_.theta);
  ParticleSet draws;
  draws.resize(particles_.size());
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  if (c.position) C.topLeftCorner<2, 2>() = c.R.topLeftCorner<2, 2>();
  if (c.heading) C(2, 2) = c.R(c.size - 1, c.size - 1);
  if (!c.heading) C(2, 2) = heading_variance < kKnownHeading ? 2.0 * heading_variance : 0.0;
  motion_.scatter(draws, 0, draws.size(), {}, C);
  for (std::size_t i = 1; i < particles_.size(); i += 2) {
    double& theta = particles_.theta[i];
    if (c.heading) {
      theta = wrap_angle(*c.heading + draws.theta[i]);
    } else if (heading_variance < kKnownHeading) {
      theta = wrap_angle(from_path + draws.theta[i]);
    } else if (random_.uniform() < kAnyHeading) {
      theta = random_.uniform(-std::numbers::pi, std::numbers::pi);
    }
    if (!c.position) continue;
    const Vector2 base = *c.position - rotate({0.0, 0.0, theta}, c.point);
    particles_.x[i] = base.x() + draws.x[i];
    particles_.y[i] = base.y() + draws.y[i];
  }
  std::fill(particles_.weight.begin(), particles_.weight.end(), 1.0 / static_cast<double>(particles_.size()));
  watch.end_run();
  last_reset_ = time;
  reset_source_ = source;
  return true;
}

// Particles catch up with the wheels.
void ParticleFilter::follow() {
  const UncertainMotion motion = track_.behind();
  if (motion.covariance.isZero(0.0) && motion.X_BB == Pose2{}) return;
  motion_.move(particles_, motion);
  track_.follow();
  X_OB_ = track_.at(track_.newest());
  refresh_estimate();
}

void ParticleFilter::refresh_estimate() {
  estimate_ = laser_heard_ ? estimate_of_heaviest(particles_, histogram_) : estimate_of(particles_);
}

// The set takes log_weight_ in, answers, and is drawn anew if few particles count.
void ParticleFilter::update_weights() {
  if (!reweigh(particles_.weight, log_weight_)) {
    ++weightless_;
    return;
  }
  effective_size_ = effective_size(particles_.weight);
  refresh_estimate();
  ++since_resampling_;
  const ResamplingOptions& resampling = options_.resampling;
  if (since_resampling_ < resampling.kResampleInterval) return;
  if (effective_size_ > resampling.n_eff_share * static_cast<double>(particles_.size())) return;
  resample();
}

void ParticleFilter::resample() {
  const ParticleCountOptions& count = options_.count;
  std::size_t wanted = static_cast<std::size_t>(count.max_particles);
  if (count.min_particles < count.max_particles) {
    histogram_.fill(particles_);
    wanted = kld_count(histogram_, count.kPfErr, count.kPfZ, static_cast<std::size_t>(count.min_particles),
                       wanted);
  }
  systematic_draw(particles_.weight, wanted, random_.uniform(), which_);
  take(particles_, which_, drawn_);
  std::swap(particles_, drawn_);
  since_resampling_ = 0;
}

Estimate ParticleFilter::estimate_at(Time time) const {
  const Time newest = track_.newest();
  const Duration longest = Duration::seconds(options_.motion.kExtrapolation);
  const Time reached = std::clamp(time, newest, newest + longest);
  const UncertainMotion behind = track_.behind();
  const Pose2 moved = inverse(X_OB_) * track_.at(reached);
  const double c = std::cos(estimate_.X_MB.theta);
  const double s = std::sin(estimate_.X_MB.theta);
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose(0, 2) = -(s * moved.x + c * moved.y);
  by_pose(1, 2) = c * moved.x - s * moved.y;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() << c, -s, s, c;
  Estimate estimate;
  estimate.time = reached;
  estimate.X_MB = estimate_.X_MB * moved;
  estimate.twist = track_.twist();
  estimate.covariance =
      by_pose * estimate_.covariance * by_pose.transpose() + R * behind.covariance * R.transpose();
  estimate.covariance = 0.5 * (estimate.covariance + estimate.covariance.transpose()).eval();
  estimate.covariance.diagonal().array() += kLeastVariance;
  estimate.gyro_bias = track_.gyro_bias();
  return estimate;
}

}  // namespace bw::localization
