#include "components/tools/experiments/anticipation_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

constexpr std::string_view kColors[] = {"#b3261e", "#1f6fb2", "#187a2f", "#8a4fbe",
                                        "#c77700", "#00838f", "#5d4037", "#616161"};
constexpr std::string_view kSmall = "font-size=\"11\" fill=\"#444\"";
constexpr double kPixelsPerMeter = 44.0;
constexpr double kLeft = -1.0, kRight = 11.0, kTop = 4.0, kBottom = -4.0;  // [m] shown
constexpr double kShownTime = 20.0;                                        // [s]

std::string color(std::size_t index) { return std::string(kColors[index % std::size(kColors)]); }

Vector2 pixel(const Vector2& p) {
  return {(p.x() - kLeft) * kPixelsPerMeter, (kTop - p.y()) * kPixelsPerMeter};
}

bool is_shown(const Vector2& p) {
  return p.x() >= kLeft && p.x() <= kRight && p.y() >= kBottom && p.y() <= kTop;
}

// A person's dots, one every second, with the time beside them.
void draw_person(SvgWriter& svg, const SceneObstacle& person, const std::string& name) {
  for (int second = 0; second <= static_cast<int>(kShownTime); ++second) {
    const Vector2 p = person.position + second * person.velocity;
    if (!is_shown(p)) continue;
    svg.circle(pixel(p), 0.3 * kPixelsPerMeter, "fill=\"none\" stroke=\"#bbb\"");
    svg.text(pixel(p) + Vector2(-7.0, 4.0), name + std::to_string(second), kSmall);
  }
}

void draw_way(SvgWriter& svg, const std::vector<TimedPosition>& path, const std::string& stroke) {
  std::vector<Vector2> line;
  for (const TimedPosition& p : path) {
    if (p.time > kShownTime || !is_shown(p.position)) break;
    line.push_back(pixel(p.position));
    const double seconds = std::round(p.time);
    if (std::abs(p.time - seconds) < 1e-6) svg.circle(line.back(), 3.0, "fill=\"" + stroke + "\"");
  }
  svg.polyline(line, "stroke=\"" + stroke + "\" stroke-width=\"1.5\"");
}

}  // namespace

std::string crossing_picture(const std::vector<CrossingResult>& results, const CrossingGeometry& geometry,
                             std::size_t run) {
  SvgWriter svg((kRight - kLeft) * kPixelsPerMeter,
                (kTop - kBottom) * kPixelsPerMeter + 18.0 * static_cast<double>(results.size()) + 8.0);
  svg.rectangle({0.0, 0.0}, (kRight - kLeft) * kPixelsPerMeter, (kTop - kBottom) * kPixelsPerMeter,
                "fill=\"#fafafa\"");
  const std::uint64_t seed = results.at(0).runs.at(run).seed;
  const Scene scene = crossing_scene(geometry, seed);
  draw_person(svg, scene.obstacles[0], "A");
  draw_person(svg, scene.obstacles[1], "B");
  for (std::size_t i = 0; i < results.size(); ++i) {
    const CrossingRun& shown = results[i].runs.at(run);
    draw_way(svg, shown.path, color(i));
    const double y = (kTop - kBottom) * kPixelsPerMeter + 18.0 * static_cast<double>(i + 1);
    svg.rectangle({4.0, y - 9.0}, 10.0, 10.0, "fill=\"" + color(i) + "\"");
    svg.text({20.0, y},
             results[i].entry.label + ": A " + std::string(name_of(shown.passing_a)) + ", B " +
                 std::string(name_of(shown.passing_b)) + ", largest CI " +
                 fixed(shown.episode.max_collision_index, 2),
             kSmall);
  }
  return std::move(svg).finish();
}

std::string index_picture(const std::vector<HallwayDrive>& drives, const std::string& episode,
                          bool people_react) {
  constexpr double kColumn = 120.0, kHeight = 200.0, kMargin = 30.0;
  std::vector<std::string> planners;
  for (const HallwayDrive& drive : drives) {
    if (std::find(planners.begin(), planners.end(), drive.planner) == planners.end())
      planners.push_back(drive.planner);
  }
  const double width = kMargin + kColumn * static_cast<double>(planners.size());
  const auto height_of = [](double index) { return 10.0 + kHeight * (1.0 - index); };
  SvgWriter svg(width, kHeight + 40.0);
  for (const double limit : {0.0, 0.14, 0.54, 1.0}) {
    svg.line({kMargin, height_of(limit)}, {width, height_of(limit)}, "stroke=\"#ccc\"");
    svg.text({0.0, height_of(limit) + 4.0}, fixed(limit, 2), kSmall);
  }
  for (std::size_t i = 0; i < planners.size(); ++i) {
    const double left = kMargin + kColumn * static_cast<double>(i);
    double x = left + 15.0;
    for (const HallwayDrive& drive : drives) {
      if (drive.planner != planners[i] || drive.episode != episode || drive.people_react != people_react ||
          drive.own_senses)
        continue;
      svg.circle({x, height_of(drive.max_collision_index)}, 3.0,
                 "fill=\"" + color(i) + "\" fill-opacity=\"0.6\"");
      x += 4.0;
    }
    svg.text({left + 10.0, kHeight + 28.0}, planners[i], kSmall);
  }
  return std::move(svg).finish();
}

}  // namespace bw
