#include "components/lab/people_training/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "components/lab/people_training/figures.hpp"

namespace bw::people {
namespace {

constexpr int kSteps = 10;

struct Step {
  double weight = 0.0;
  double scores = 0.0;
  double positives = 0.0;
  int count = 0;

  double mean() const { return count > 0 ? scores / weight : 0.0; }
  double share() const { return count > 0 ? positives / weight : 0.0; }
};

std::array<Step, kSteps> steps_of(std::span<const double> scores, std::span<const std::uint8_t> positive,
                                  std::span<const double> weights) {
  std::array<Step, kSteps> steps;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    Step& step = steps[static_cast<std::size_t>(std::min(kSteps - 1, static_cast<int>(kSteps * scores[i])))];
    step.weight += weights[i];
    step.scores += weights[i] * scores[i];
    step.positives += weights[i] * positive[i];
    ++step.count;
  }
  return steps;
}

/// As many humans as others.
std::vector<double> even_weights(std::span<const Sample> samples) {
  const auto others = static_cast<double>(std::ranges::count(samples, Kind::other, &Sample::kind));
  const double human = others / std::max(1.0, static_cast<double>(samples.size()) - others);
  std::vector<double> weights;
  for (const Sample& sample : samples) weights.push_back(sample.kind == Kind::other ? 1.0 : human);
  return weights;
}

std::vector<double> column(std::span<const HumanScores> scores, double HumanScores::*score) {
  std::vector<double> values;
  for (const HumanScores& s : scores) values.push_back(s.*score);
  return values;
}

template <class... Values>
void line(std::string& text, const char* format, Values... values) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, values...);
  text += buffer;
}

/// A row for everything that `belongs`.
template <class Belongs>
void confusion(std::string& text, const char* name, std::span<const Sample> samples,
               std::span<const HumanScores> scores, const Belongs& belongs) {
  int count = 0;
  int leg = 0;
  int body = 0;
  HumanScores sum;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!belongs(samples[i])) continue;
    ++count;
    leg += scores[i].leg >= 0.5;
    body += scores[i].body >= 0.5;
    sum.leg += scores[i].leg;
    sum.body += scores[i].body;
  }
  const double n = std::max(count, 1);
  line(text, "  %-14s %8d   %5.3f  %5.3f   %5.3f  %5.3f\n", name, count, sum.leg / n, leg / n, sum.body / n,
       body / n);
}

void confusions(std::string& text, std::span<const Sample> samples, std::span<const HumanScores> scores) {
  text +=
      "Confusions: mean score, and share of scores from 0.5 on, as a leg and as a body (two legs in one)\n";
  text += "  truly           outlines   leg            body\n";
  confusion(text, "a leg", samples, scores, [](const Sample& s) { return s.kind == Kind::leg; });
  confusion(text, "a body", samples, scores, [](const Sample& s) { return s.kind == Kind::body; });
  for (std::size_t piece = 0; piece < kPieces; ++piece) {
    confusion(text, name_of(static_cast<Piece>(piece)), samples, scores,
              [&](const Sample& s) { return s.kind == Kind::other && s.piece == static_cast<Piece>(piece); });
  }
}

void calibration(std::string& text, const char* name, const std::vector<double>& scores,
                 const std::vector<std::uint8_t>& positive, const std::vector<double>& weights) {
  const ClassifierFigures f = figures_of(scores, positive);
  line(text, "%s: ROC area %.4f; from 0.5 on are %.3f of them; calibration error %.4f\n", name, f.area,
       f.recall, calibration_error(scores, positive, weights));
  text += "  score         outlines   mean score   truly\n";
  const auto steps = steps_of(scores, positive, weights);
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps[static_cast<std::size_t>(i)];
    line(text, "  %.1f to %.1f   %10d        %5.3f   %5.3f\n", 0.1 * i, 0.1 * (i + 1), step.count,
         step.mean(), step.share());
  }
}

void by_points(std::string& text, std::span<const Sample> samples, std::span<const HumanScores> scores,
               const std::vector<double>& even) {
  text += "Legs by the number of points of an outline\n";
  text += "  points   outlines      legs   ROC area   calibration error   mean score of a leg\n";
  constexpr std::array<int, 7> kFrom = {2, 3, 4, 6, 9, 15, 1'000'000};
  for (std::size_t k = 0; k + 1 < kFrom.size(); ++k) {
    std::vector<double> here;
    std::vector<std::uint8_t> positive;
    std::vector<double> weights;
    double of_legs = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto points = static_cast<int>(samples[i].features[Feature::points]);
      if (points < kFrom[k] || points >= kFrom[k + 1]) continue;
      here.push_back(scores[i].leg);
      weights.push_back(even[i]);
      positive.push_back(samples[i].kind == Kind::leg);
      if (positive.back() != 0) of_legs += scores[i].leg;
    }
    const ClassifierFigures f = figures_of(here, positive);
    line(text, "  from %-3d %9zu %9d     %.4f              %.4f                 %.3f\n", kFrom[k],
         here.size(), f.positives, f.area, calibration_error(here, positive, weights),
         of_legs / std::max(f.positives, 1));
  }
}

}  // namespace

double calibration_error(std::span<const double> scores, std::span<const std::uint8_t> positive,
                         std::span<const double> weights) {
  double sum = 0.0;
  double all = 0.0;
  for (const Step& step : steps_of(scores, positive, weights)) {
    sum += step.weight * std::abs(step.mean() - step.share());
    all += step.weight;
  }
  return all > 0.0 ? sum / all : 0.0;
}

std::vector<std::uint8_t> is(Kind kind, std::span<const Sample> samples) {
  std::vector<std::uint8_t> flags;
  for (const Sample& sample : samples) flags.push_back(sample.kind == kind);
  return flags;
}

std::string report_of(std::span<const Sample> samples, std::span<const HumanScores> scores) {
  std::string text;
  const std::vector<double> even = even_weights(samples);
  confusions(text, samples, scores);
  text += "\nShares are those where as many humans are as others.\n";
  calibration(text, "Legs", column(scores, &HumanScores::leg), is(Kind::leg, samples), even);
  text += "\n";
  calibration(text, "Bodies", column(scores, &HumanScores::body), is(Kind::body, samples), even);
  text += "\n";
  std::vector<double> human;
  std::vector<std::uint8_t> is_human;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    human.push_back(std::min(1.0, scores[i].leg + scores[i].body));
    is_human.push_back(samples[i].kind != Kind::other);
  }
  calibration(text, "Humans, leg + body", human, is_human, even);
  text += "\n";
  by_points(text, samples, scores, even);
  return text;
}

}  // namespace bw::people
