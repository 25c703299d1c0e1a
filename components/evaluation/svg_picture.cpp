#include "components/evaluation/svg_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "components/evaluation/picture_parts.hpp"
#include "components/evaluation/picture_view.hpp"
#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

using namespace drawing;

constexpr double kMargin = 28.0;  // of the page [px]
constexpr double kHeader = 92.0;  // [px]
constexpr double kFooter = 84.0;  // [px]
constexpr int kSpeedSteps = 12;

int speed_step(double speed, double top) {
  return std::clamp(static_cast<int>(std::lround(speed / top * (kSpeedSteps - 1))), 0, kSpeedSteps - 1);
}

/// One line per stay of a person in the scene; the one of the closest encounter stands out.
void draw_people_paths(SvgWriter& svg, const RunRecording& recording, const ScoreCard& card,
                       const PictureView& view) {
  constexpr double kLongestHop = 2.5;  // farther between two looks: another stay [m]
  std::map<std::uint32_t, std::vector<std::vector<Vector2>>> stays;
  std::map<std::uint32_t, std::pair<std::size_t, Vector2>> last;  // moment and position
  for (std::size_t i = 0; i < recording.moments.size(); ++i) {
    for (const TruePerson& person : recording.moments[i].people) {
      const auto before = last.find(person.id);
      const bool goes_on = before != last.end() && before->second.first + 1 == i &&
                           (before->second.second - person.position).norm() < kLongestHop;
      if (!goes_on) stays[person.id].emplace_back();
      stays[person.id].back().push_back(view(person.position));
      last[person.id] = {i, person.position};
    }
  }
  for (const auto& [id, lines] : stays) {
    const bool is_closest = card.closest && card.closest->person == id;
    for (const std::vector<Vector2>& line : lines) {
      svg.polyline(line, style({{"stroke", std::string(kPeople)},
                                {"stroke-width", is_closest ? "2.2" : "1.4"},
                                {"stroke-opacity", is_closest ? "0.85" : "0.4"},
                                {"stroke-linejoin", "round"}}));
    }
  }
}

void draw_robot_path(SvgWriter& svg, const RunRecording& recording, const PictureView& view) {
  const std::vector<RecordedMoment>& moments = recording.moments;
  std::vector<Vector2> whole;
  whole.reserve(moments.size());
  for (const RecordedMoment& moment : moments) whole.push_back(view(moment.X_MB.position()));
  if (whole.size() < 2) return;
  svg.polyline(whole,
               "stroke=\"#ffffff\" stroke-width=\"8\" stroke-linejoin=\"round\" stroke-linecap=\"round\"");
  for (std::size_t i = 0; i + 1 < moments.size();) {
    const int step = speed_step(moments[i].speed, recording.top_speed);
    std::vector<Vector2> piece{whole[i]};
    while (i + 1 < moments.size() && speed_step(moments[i].speed, recording.top_speed) == step)
      piece.push_back(whole[++i]);
    svg.polyline(piece, style({{"stroke", speed_color(static_cast<double>(step) / (kSpeedSteps - 1))},
                               {"stroke-width", "4.5"},
                               {"stroke-linejoin", "round"},
                               {"stroke-linecap", "round"}}));
  }
}

void draw_person(SvgWriter& svg, const PictureView& view, const TruePerson& person,
                 const std::string& label) {
  const Vector2 at = view(person.position);
  svg.circle(at, person.radius * view.scale,
             style({{"fill", std::string(kPeople)},
                    {"fill-opacity", "0.13"},
                    {"stroke", std::string(kPeople)},
                    {"stroke-opacity", "0.75"},
                    {"stroke-width", "1.2"}}));
  svg.text(at + Vector2(0, 4), label, label_style(kPeople, 11, "middle"));
}

void draw_robot(SvgWriter& svg, const PictureView& view, const RunRecording& recording,
                const RecordedMoment& moment, const std::string& label) {
  const Vector2 at = view(moment.X_MB.position());
  const Vector2 front = view(moment.X_MB * Vector2(front_of(recording.robot), 0.0));
  const std::string color = speed_color(moment.speed / recording.top_speed);
  draw_footprint(
      svg, view, recording.robot, moment.X_MB,
      style({{"fill", "#ffffff"}, {"fill-opacity", "0.6"}, {"stroke", color}, {"stroke-width", "2"}}));
  if (front.allFinite())  // else the truth has no heading
    svg.line(at + (front - at) * 0.55, front, style({{"stroke", color}, {"stroke-width", "3"}}));
  svg.text(at + Vector2(0, 4), label, label_style(kInk, 11, "middle", 600));
}

/// Everybody every footprint_period, numbered by the second; whoever stands is drawn once.
void draw_bodies(SvgWriter& svg, const RunRecording& recording, const PictureView& view,
                 const PictureOptions& options) {
  const bool has_room = recording.robot.radius * view.scale > 11.0;
  std::map<std::uint32_t, Vector2> drawn;
  std::optional<Vector2> robot_drawn;
  const auto stands = [](const Vector2& before, const Vector2& now, double radius) {
    return (now - before).norm() < radius / 2.0;
  };
  double next = 0.0;
  for (const RecordedMoment& moment : recording.moments) {
    if (moment.time + 1e-6 < next) continue;
    next = (std::floor(moment.time / options.footprint_period + 1e-6) + 1.0) * options.footprint_period;
    const std::string label = has_room ? fixed(moment.time, 0) : "";
    const Vector2 robot = moment.X_MB.position();
    for (const TruePerson& person : moment.people) {
      if ((person.position - robot).norm() > options.near) continue;
      const auto before = drawn.find(person.id);
      if (before != drawn.end() && stands(before->second, person.position, person.radius)) continue;
      draw_person(svg, view, person, label);
      drawn[person.id] = person.position;
    }
    if (robot_drawn && stands(*robot_drawn, robot, recording.robot.radius)) continue;
    draw_robot(svg, view, recording, moment, label);
    robot_drawn = robot;
  }
}

void draw_ends(SvgWriter& svg, const RunRecording& recording, const PictureView& view) {
  for (std::size_t i = 0; i < recording.goals.size(); ++i) {
    const Vector2 goal = view(recording.goals[i]);
    svg.circle(goal, 9, style({{"fill", "none"}, {"stroke", std::string(kInk)}, {"stroke-width", "2"}}));
    svg.circle(goal, 4, fill(kInk));
    const std::string label = recording.goals.size() > 1 ? "goal " + std::to_string(i + 1) : "goal";
    svg.text(goal + Vector2(0, -15), label, label_style(kInk, 13, "middle", 600));
  }
  if (recording.moments.empty()) return;
  const Vector2 start = view(recording.moments.front().X_MB.position());
  svg.text(start + Vector2(0, -recording.robot.radius * view.scale - 7), "start",
           label_style(kInk, 13, "middle", 600));
}

void draw_encounter(SvgWriter& svg, const RunRecording& recording, const Encounter& encounter,
                    const PictureView& view) {
  const Vector2 robot = view(encounter.X_MB.position());
  const Vector2 person = view(encounter.person_position);
  const std::string ring = style({{"fill", std::string(kAlarm)},
                                  {"fill-opacity", "0.14"},
                                  {"stroke", std::string(kAlarm)},
                                  {"stroke-width", "2.2"}});
  draw_footprint(svg, view, recording.robot, encounter.X_MB, ring);
  svg.circle(person, encounter.person_radius * view.scale, ring);
  svg.line(robot, person,
           style({{"stroke", std::string(kAlarm)}, {"stroke-width", "1.8"}, {"stroke-dasharray", "4 3"}}));

  // The label goes away from the robot's side and stays on the page.
  const bool below = person.y() > robot.y();
  const double off = encounter.person_radius * view.scale + 26.0;
  const std::string text = fixed(encounter.gap, 2) + " m at " + fixed(encounter.time, 1) + " s";
  const double half = 4.2 * static_cast<double>(text.size()) + 12.0;
  const Vector2 at(
      std::clamp(person.x(), view.corner.x() + half + 6, view.corner.x() + view.width() - half - 6),
      std::clamp(person.y() + (below ? off : -off), view.corner.y() + 20,
                 view.corner.y() + view.height() - 20));
  svg.line(person, at, style({{"stroke", std::string(kAlarm)}, {"stroke-width", "1"}}));
  svg.rectangle(at - Vector2(half, 13), 2 * half, 26,
                "rx=\"13\" fill=\"#ffffff\" stroke=\"#d6223b\" stroke-width=\"1.4\"");
  svg.text(at + Vector2(0, 5), text, label_style(kAlarm, 14, "middle", 600));
}

void draw_header(SvgWriter& svg, const ScoreCard& card, const PictureOptions& options) {
  svg.text({kMargin, 40}, options.title, label_style(kInk, 24, "start", 700));
  const bool failed = card.collisions > 0 || (card.finished && !card.reached);
  const std::string_view color = failed ? kAlarm : card.finished ? "#0f868c" : kSoftInk;
  std::string result = !card.finished ? options.unfinished
                       : card.reached ? "goal reached"
                                      : "goal not reached: " + card.reason;
  if (card.collisions > 0)
    result += ", " + std::to_string(card.collisions) + (card.collisions == 1 ? " contact" : " contacts");
  svg.text({options.width - kMargin, 40}, result, label_style(color, 18, "end", 700));
  const std::string facts =
      fixed(card.time_to_goal, 1) + " s   ·   " + fixed(card.path_length, 1) + " m driven   ·   " +
      fixed(card.mean_speed, 2) + " m/s on average   ·   closest person " +
      (card.closest ? fixed(card.closest->gap, 2) + " m" : "–") + "   ·   collision index up to " +
      fixed(card.max_collision_index, 2) + "   ·   jerk " + fixed(card.rms_jerk, 2) + " m/s³ rms";
  svg.text({kMargin, 70}, facts, label_style(kSoftInk, 15));
}

void draw_speed_bar(SvgWriter& svg, double top_speed, double x, double y) {
  constexpr double kCell = 17.0;
  for (int i = 0; i < kSpeedSteps; ++i) {
    svg.rectangle({x + kCell * i, y - 5}, kCell + 0.5, 10,
                  fill(speed_color(static_cast<double>(i) / (kSpeedSteps - 1))));
  }
  svg.text({x, y + 20}, "0", label_style(kSoftInk, 13));
  svg.text({x + kCell * kSpeedSteps / 2, y + 20}, "robot speed", label_style(kSoftInk, 13, "middle"));
  svg.text({x + kCell * kSpeedSteps, y + 20}, fixed(top_speed, 1) + " m/s", label_style(kSoftInk, 13, "end"));
}

void draw_legend(SvgWriter& svg, const RunRecording& recording, const PictureView& view,
                 const PictureOptions& options) {
  const double y = view.corner.y() + view.height() + 32.0;
  draw_scale_bar(svg, view, {kMargin, y});
  draw_speed_bar(svg, recording.top_speed, kMargin + 260.0, y);
  double x = kMargin + 540.0;
  const auto entry = [&](std::string_view text, double width) {
    svg.text({x + 22, y + 5}, text, label_style(kSoftInk, 13));
    x += width;
  };
  svg.circle({x + 6, y}, 8, "fill=\"#ffffff\" stroke=\"#0f868c\" stroke-width=\"2\"");
  entry("robot every " + fixed(options.footprint_period, 0) + " s", 160);
  svg.circle({x + 6, y}, 8, "fill=\"#6a5acd\" fill-opacity=\"0.13\" stroke=\"#6a5acd\" stroke-width=\"1.2\"");
  entry("people near it, same second", 232);
  svg.line({x - 4, y}, {x + 14, y}, "stroke=\"#6a5acd\" stroke-opacity=\"0.5\" stroke-width=\"1.8\"");
  entry("people's ways", 134);
  svg.circle({x + 6, y}, 8, "fill=\"#d6223b\" fill-opacity=\"0.14\" stroke=\"#d6223b\" stroke-width=\"2.2\"");
  entry("closest encounter", 0);
}

}  // namespace

std::string svg_picture(const RunRecording& recording, const ScoreCard& card, const PictureOptions& options) {
  const PictureView view = view_of(recording, options.width - 2.0 * kMargin, {kMargin, kHeader});
  const double height = kHeader + view.height() + kFooter;
  SvgWriter svg(options.width, height);
  svg.rectangle({0, 0}, options.width, height, "fill=\"#ffffff\"");
  svg.open("<clipPath id=\"view\">");
  svg.rectangle(view.corner, view.width(), view.height(), "rx=\"6\"");
  svg.close("</clipPath>");
  svg.open("<g clip-path=\"url(#view)\">");
  draw_surroundings(svg, recording, view);
  draw_people_paths(svg, recording, card, view);
  draw_robot_path(svg, recording, view);
  draw_bodies(svg, recording, view, options);
  if (card.closest) draw_encounter(svg, recording, *card.closest, view);
  draw_ends(svg, recording, view);
  svg.close("</g>");
  svg.rectangle(view.corner, view.width(), view.height(),
                "rx=\"6\" fill=\"none\" stroke=\"#c8d0d9\" stroke-width=\"1\"");
  draw_header(svg, card, options);
  draw_legend(svg, recording, view, options);
  return std::move(svg).finish();
}

}  // namespace bw
