// What a classifier makes of outlines whose truth is known: how well it orders them, what it confuses them
// with, and whether a score is the share that it says.
#pragma once

#include <span>
#include <string>

#include "components/lab/people_training/samples.hpp"
#include "components/people/detector/classifier.hpp"

namespace bw::people {

/// How far scores are from shares: the mean of |mean score - share of positives| over ten steps of the score,
/// each weighted by what it holds. An outline counts as often as its weight says.
double calibration_error(std::span<const double> scores, std::span<const std::uint8_t> positive,
                         std::span<const double> weights);

std::vector<std::uint8_t> is(Kind kind, std::span<const Sample> samples);

/// Tables as text: confusions by kind, scores against shares, legs by the number of their points. `scores`:
/// one for each sample. For the shares humans are weighted so that there are as many as others.
std::string report_of(std::span<const Sample> samples, std::span<const HumanScores> scores);

}  // namespace bw::people
