// What pictures of drives have in common: colours, styles, the map, bodies, the scale.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "components/evaluation/picture_view.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/evaluation/svg_writer.hpp"

namespace bw::drawing {

inline constexpr std::string_view kInk = "#1b2530";
inline constexpr std::string_view kSoftInk = "#5c6b7a";
inline constexpr std::string_view kPeople = "#6a5acd";
inline constexpr std::string_view kAlarm = "#d6223b";

/// A list of attributes.
std::string style(std::initializer_list<std::pair<std::string_view, std::string>> attributes);
std::string fill(std::string_view color);
std::string label_style(std::string_view color, int size, std::string_view anchor = "start",
                        int weight = 400);

/// Standing is red, half speed amber, full speed teal. `share` of full speed, 0 to 1.
std::string speed_color(double share);

/// Floor, walls and pillars.
void draw_surroundings(SvgWriter& svg, const RunRecording& recording, const PictureView& view);

/// The robot's outline, or its disc where it has none or the heading is not known.
void draw_footprint(SvgWriter& svg, const PictureView& view, const Footprint& robot, const Pose2& X_MB,
                    const std::string& look);

/// Of the outline, on the line that the robot looks along [m].
double front_of(const Footprint& robot);

/// A length that is round, from `left` on the page.
void draw_scale_bar(SvgWriter& svg, const PictureView& view, const Vector2& left);

}  // namespace bw::drawing
