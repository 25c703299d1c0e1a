// The learned prediction: its frame, its gradient, its file, when it steps back, and recordings that it never saw.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "components/lab/people_training/prediction_fit.hpp"
#include "components/lab/people_training/prediction_judge.hpp"
#include "components/model/random.hpp"
#include "components/people/files/head_file.hpp"
#include "components/world/files/track_file.hpp"

namespace bw::people {
namespace {

HeadWeights some_weights(std::uint64_t seed) {
  Random random(seed);
  HeadWeights weights{Eigen::VectorXd::Zero(kHeadInputs), Eigen::VectorXd::Ones(kHeadInputs), {}};
  for (const auto& [from, to] : {std::pair{kHeadInputs, 8}, std::pair{8, kHeadOutputs}}) {
    HeadLayer layer{Eigen::MatrixXd(to, from), Eigen::VectorXd(to)};
    for (double& weight : layer.W.reshaped()) weight = 0.3 * random.normal();
    for (double& weight : layer.b.reshaped()) weight = 0.3 * random.normal();
    weights.layers.push_back(layer);
  }
  return weights;
}

const std::vector<Vector2> kPast{{1.0, 2.0}, {0.7, 1.6}, {0.5, 1.1}, {0.4, 0.6}};

std::string text_of(const HeadWeights& weights) {
  std::ostringstream out;
  write_head(out, weights);
  return out.str();
}

HeadWeights read(const std::string& text) {
  std::istringstream input(text);
  return read_head(input, "head.txt");
}

std::string complaint_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TrackedPerson somebody(const Vector2& position, Time seen) {
  TrackedPerson person{{.id = 1, .position = position, .velocity = {1.0, 0.0}}};
  person.covariance.diagonal() << 1e-4, 1e-4, 0.01, 0.01;
  person.last_seen = seen;
  return person;
}

// Turned by 2 rad and moved: the means are turned and moved, the covariances turned. To rounding.
TEST(LearnedPrediction, IsTheSameTurnedAndMoved) {
  const HeadWeights weights = some_weights(1);
  const auto here = predict_by_head(weights, kPast);
  const Pose2 X{-3.0, 5.0, 2.0};
  std::vector<Vector2> moved;
  for (const Vector2& position : kPast) moved.push_back(X * position);
  const auto there = predict_by_head(weights, moved);
  ASSERT_TRUE(here && there);
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(X.theta).toRotationMatrix();
  for (std::size_t k = 0; k < kAhead; ++k) {
    EXPECT_NEAR(((*there)[k].position - X * (*here)[k].position).norm(), 0.0, 1e-12);
    EXPECT_NEAR(((*there)[k].covariance - R * (*here)[k].covariance * R.transpose()).norm(), 0.0, 1e-12);
    EXPECT_GT((*here)[k].covariance.determinant(), 0.0);
  }
}

// Central differences over 1e-5: the loss is smooth, so its third derivative leaves some 1e-9.
TEST(LearnedPrediction, GradientIsThatOfDifferences) {
  HeadWeights weights = some_weights(2);
  for (int k = 0; k < kAhead; ++k)
    weights.layers[1].b.segment<2>(k * kPerStep + 2).setConstant(2.0);  // wide: no slope is cut
  const std::vector<WalkSample> samples = walk_samples(7, 1);
  const std::vector<const WalkSample*> batch{&samples[0], &samples[1], &samples[2]};
  std::vector<HeadLayer> gradient;
  batch_loss(weights, batch, &gradient);
  Random random(3);
  for (int n = 0; n < 60; ++n) {
    const std::size_t l = random.bits() % 2;
    const auto at =
        static_cast<Eigen::Index>(random.bits() % static_cast<std::uint64_t>(weights.layers[l].W.size()));
    double& weight = weights.layers[l].W.reshaped()[at];
    const double kept = weight;
    const double step = 1e-5;
    weight = kept + step;
    const double above = batch_loss(weights, batch, nullptr);
    weight = kept - step;
    const double below = batch_loss(weights, batch, nullptr);
    weight = kept;
    EXPECT_NEAR(gradient[l].W.reshaped()[at], (above - below) / (2.0 * step), 1e-6);
  }
}

TEST(LearnedPrediction, IsFittedToTheSameBytes) {
  const std::vector<WalkSample> samples = walk_samples(11, 3);
  const FitOptions options{.hidden = 4, .epochs = 1};
  EXPECT_EQ(text_of(fit_head(samples, options)), text_of(fit_head(walk_samples(11, 3), options)));
}

// Five digits: what is read is written again as it was.
TEST(LearnedPrediction, FileIsReadAsWritten) {
  const std::string text = text_of(some_weights(4));
  EXPECT_EQ(text_of(read(text)), text);
}

TEST(LearnedPrediction, RefusesAFileOfAnotherHashOrWithWhatIsNoNumber) {
  HeadWeights weights = some_weights(5);
  const std::string text = text_of(weights);
  std::string changed = text;
  changed[changed.size() - 2] = changed[changed.size() - 2] == '1' ? '2' : '1';
  EXPECT_NE(complaint_of(changed).find("head.txt:2"), std::string::npos) << complaint_of(changed);
  EXPECT_NE(complaint_of(changed).find("hash"), std::string::npos) << complaint_of(changed);
  // Written by somebody who trusted it: the hash is right, line 6 is the first of the first layer.
  weights.layers[0].W(0, 3) = std::nan("");
  EXPECT_NE(complaint_of(text_of(weights)).find("head.txt:6"), std::string::npos)
      << complaint_of(text_of(weights));
  EXPECT_NE(complaint_of(text_of(weights)).find("finite"), std::string::npos)
      << complaint_of(text_of(weights));
  EXPECT_NE(complaint_of("weights\n").find("head.txt:1"), std::string::npos);
}

TEST(LearnedPrediction, StepsBackFromWhatIsNotFinite) {
  HeadWeights weights = some_weights(6);
  weights.layers[1].b[0] = std::nan("");
  EXPECT_FALSE(predict_by_head(weights, kPast));
  EXPECT_FALSE(predict_by_head(some_weights(6), std::span(kPast).first(2)));  // too short a past
  LearnedPrediction prediction(weights);
  for (int i = 0; i < 20; ++i) {
    const Time now = Time::seconds(10.0 + 0.1 * i);
    EXPECT_FALSE(prediction.predict(somebody({0.1 * i, 0.0}, now), now));
  }
  EXPECT_GT(prediction.refused(), 0);
}

// Weights of 0: straight on by the last 0.8 s, deviations of the unit, at 1 s 0.14 m. Who goes straight on is predicted; who
// turns back at once at 1 m/s is 2 m off 1 s later, a residual of (2 / 0.14)^2, and is left to constant velocity. After four
// residuals within, 0.5 s apart, it is trusted again.
TEST(LearnedPrediction, StepsBackFromWhoWalksOtherwise) {
  HeadWeights weights = some_weights(7);
  for (HeadLayer& layer : weights.layers) {
    layer.W.setZero();
    layer.b.setZero();
  }
  LearnedPrediction prediction(weights);
  const auto walks = [&](int i) {
    const Time now = Time::seconds(10.0 + 0.1 * i);
    const double x = i < 40 ? 0.1 * i : 8.0 - 0.1 * i;
    return prediction.predict(somebody({x, 0.0}, now), now).has_value();
  };
  for (int i = 0; i < 8; ++i) EXPECT_FALSE(walks(i)) << i;  // no past of 0.8 s yet
  for (int i = 8; i < 40; ++i) EXPECT_TRUE(walks(i)) << i;
  int refused = 0;
  for (int i = 40; i < 100; ++i) refused += walks(i) ? 0 : 1;
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(walks(100));
}

// By the rules, and without weights by a predictor that has none: straight on.
TEST(LearnedPrediction, NeedsWeightsAndEndsWhereTheNetDoes) {
  PredictionOptions options;
  EXPECT_FALSE(options.violated_rule());
  options.model = PredictionModel::learned;
  EXPECT_TRUE(options.violated_rule());
  options.weights = "head.txt";
  EXPECT_FALSE(options.violated_rule());
  options.horizon = 4.5;
  EXPECT_TRUE(options.violated_rule());
  std::vector<TrackedPerson> people{somebody({0.0, 0.0}, Time::seconds(10.0))};
  Predictor predictor(options);
  predictor.predict(people, {}, Time::seconds(10.0));
  EXPECT_NEAR(people[0].predictions[7].position.x(), 4.0, 1e-12);
}

TEST(LearnedPrediction, LeavesOutWhoIsNotSeen) {
  LearnedPrediction prediction(some_weights(8));
  for (int i = 0; i < 20; ++i) {
    const Time now = Time::seconds(10.0 + 0.1 * i);
    prediction.predict(somebody({0.1 * i, 0.0}, now), now);
  }
  const Time now = Time::seconds(12.0);
  EXPECT_FALSE(prediction.predict(somebody({2.0, 0.0}, now - Duration::seconds(0.3)), now));
}

// Places that it was not trained on, annotations with a tracker's 0.03 m (prediction/README.md 7.8): more likely than by constant
// velocity at 1, 2, 3 and 4 s.
TEST(LearnedPrediction, WinsOnRecordedPeople) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set: no recorded people";
  const HeadWeights head = read_head(std::string(BANDWAGON_SOURCE_DIR) + "/config/people/learned_head.txt");
  const Judging how{.noise = 0.03};
  for (const std::string name : {"eth", "hotel", "zara01", "students001"}) {
    const std::vector<Track> tracks =
        read_tracks(std::string(shared) + "/data/eth_ucy_pedestrians/" + name + ".csv");
    const auto straight_on = judge_prediction(tracks, Predictor({}), how);
    const auto by_head = judge_prediction(tracks, Predictor({}, head), how);
    for (std::size_t h = 0; h < how.times.size(); ++h) {
      EXPECT_LT(by_head[h].loss, straight_on[h].loss) << name << " at " << how.times[h] << " s";
      EXPECT_GT(by_head[h].count, 1000) << name;
    }
  }
}

}  // namespace
}  // namespace bw::people
