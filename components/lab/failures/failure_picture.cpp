#include "components/lab/failures/failure_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "components/evaluation/picture_parts.hpp"

namespace bw {
namespace {

using namespace drawing;

constexpr double kMargin = 24.0;      // of the page [px]
constexpr double kBefore = 4.0;       // ways of people so long before the contact [s]
constexpr double kAfter = 1.5;        // and of the robot after it [s]
constexpr double kRoom = 1.0;         // about what is shown [m]
constexpr double kLeastSize = 6.0;    // of the place shown [m]
constexpr double kFlattest = 0.5;     // height over width
constexpr double kLabelWay = 45.0;    // from a body to its label [px]
constexpr double kLineHeight = 20.0;  // [px]
constexpr std::string_view kWayOut = "#0f868c";
constexpr std::string_view kRobot = "#1f5fbf";

using Moments = std::vector<RecordedMoment>;

/// Straight on between moments; the first and last before and after.
Pose2 pose_at(const Moments& moments, double time) {
  const auto after = std::lower_bound(moments.begin(), moments.end(), time,
                                      [](const RecordedMoment& m, double t) { return m.time < t; });
  if (after == moments.begin()) return moments.front().X_MB;
  if (after == moments.end()) return moments.back().X_MB;
  const RecordedMoment& a = *std::prev(after);
  const RecordedMoment& b = *after;
  const double share = (time - a.time) / (b.time - a.time);
  const Vector2 place = a.X_MB.position() + share * (b.X_MB.position() - a.X_MB.position());
  return {place.x(), place.y(),
          a.X_MB.theta + share * std::remainder(b.X_MB.theta - a.X_MB.theta, 2.0 * M_PI)};
}

/// Places of a person from `from` to `until` [s], as they were looked at.
std::vector<possible::TimedPlace> way_of(const Moments& moments, std::uint32_t person, double from,
                                         double until) {
  std::vector<possible::TimedPlace> way;
  for (const RecordedMoment& moment : moments) {
    if (moment.time < from - 1e-6 || moment.time > until + 1e-6) continue;
    for (const TruePerson& one : moment.people)
      if (one.id == person) way.push_back({moment.time, one.position});
  }
  return way;
}

class Drawing {
 public:
  Drawing(const RunRecording& recording, const FailurePicture& picture)
      : recording_(recording),
        moments_(recording.moments),
        picture_(picture),
        header_(46.0 + kLineHeight * static_cast<double>(picture.lines.size())) {
    time_ = picture.contact ? picture.contact->record.time : moments_.back().time;
    if (picture.contact) motion_ = &picture.contact->verdict.motion;
    from_ = std::max(moments_.front().time, time_ - kBefore);
    if (motion_ != nullptr && !motion_->empty()) from_ = std::min(from_, motion_->front().time - 1.0);
    from_ = picture.contact ? from_ : moments_.front().time;
    view_ = find_view();
  }

  std::string text() {
    const double height = header_ + view_.height() + 76.0;
    SvgWriter svg(picture_.width, height);
    svg.rectangle({0, 0}, picture_.width, height, fill("#ffffff"));
    svg.open("<clipPath id=\"view\">");
    svg.rectangle(view_.corner, view_.width(), view_.height(), "rx=\"6\"");
    svg.close("</clipPath>");
    svg.open("<g clip-path=\"url(#view)\">");
    draw_place(svg, recording_, view_);
    draw_goals(svg);
    draw_people(svg);
    draw_robot(svg);
    draw_way_out(svg);
    draw_contact(svg);
    svg.close("</g>");
    svg.rectangle(view_.corner, view_.width(), view_.height(),
                  "rx=\"6\" fill=\"none\" stroke=\"#c8d0d9\" stroke-width=\"1\"");
    draw_header(svg);
    draw_legend(svg);
    return std::move(svg).finish();
  }

 private:
  PictureView find_view() const {
    Eigen::AlignedBox2d box;
    for (const RecordedMoment& moment : moments_)
      if (moment.time >= from_ - 1e-6 && moment.time <= time_ + kAfter) box.extend(moment.X_MB.position());
    if (motion_ != nullptr)
      for (const possible::MotionState& state : *motion_) box.extend(state.pose.position());
    if (picture_.contact)
      for (const auto& place : way_of(moments_, picture_.contact->record.person, time_ - kBefore, time_))
        box.extend(place.position);
    if (!picture_.contact)
      for (const Vector2& goal : recording_.goals) box.extend(goal);
    if (box.isEmpty()) box.extend(moments_.back().X_MB.position());
    box.min().array() -= kRoom;
    box.max().array() += kRoom;
    const auto widen = [&box](int axis, double size) {
      const double missing = std::max(0.0, size - box.sizes()[axis]);
      box.min()[axis] -= missing / 2.0;
      box.max()[axis] += missing / 2.0;
    };
    widen(0, kLeastSize);
    widen(1, std::max(kLeastSize, kFlattest * box.sizes().x()));
    widen(0, box.sizes().y());
    return {box, (picture_.width - 2.0 * kMargin) / box.sizes().x(), {kMargin, header_}};
  }

  bool is_shown(const Vector2& place, double radius) const {
    Eigen::AlignedBox2d box = view_.window_in_map;
    box.min().array() -= radius;
    box.max().array() += radius;
    return box.contains(place);
  }

  void draw_goals(SvgWriter& svg) const {
    for (const Vector2& goal : recording_.goals) {
      svg.circle(view_(goal), 9,
                 style({{"fill", "none"}, {"stroke", std::string(kInk)}, {"stroke-width", "2"}}));
      svg.text(view_(goal) + Vector2(0, -14), "goal", label_style(kInk, 13, "middle", 600));
    }
  }

  /// Everybody at the time of the contact, and their ways of the seconds before; of who is touched also after it.
  void draw_people(SvgWriter& svg) const {
    const auto now = std::min_element(moments_.begin(), moments_.end(), [this](const auto& a, const auto& b) {
      return std::abs(a.time - time_) < std::abs(b.time - time_);
    });
    for (const TruePerson& person : now->people) {
      const bool is_touched = picture_.contact && picture_.contact->record.person == person.id;
      const std::string color(is_touched ? kAlarm : kPeople);
      const std::vector<possible::TimedPlace> way = way_of(moments_, person.id, time_ - kBefore, time_);
      if (!is_shown(person.position, person.radius) && !is_touched) continue;
      draw_line(svg, way,
                {{"class", "person"},
                 {"stroke", color},
                 {"stroke-width", is_touched ? "2.5" : "1.6"},
                 {"stroke-opacity", is_touched ? "0.9" : "0.55"}});
      draw_seconds(svg, way, color, is_touched);
      svg.circle(
          view_(person.position), person.radius * view_.scale,
          style({{"fill", color}, {"fill-opacity", "0.15"}, {"stroke", color}, {"stroke-width", "1.4"}}));
      svg.text(view_(person.position) + Vector2(0, 4), std::to_string(person.id),
               label_style(color, 12, "middle", 600));
      if (!is_touched) continue;
      const double end = motion_ != nullptr && !motion_->empty() ? motion_->back().time : time_ + kAfter;
      draw_line(
          svg, way_of(moments_, person.id, time_, end),
          {{"class", "after"}, {"stroke", color}, {"stroke-width", "1.4"}, {"stroke-dasharray", "2 5"}});
    }
  }

  /// Where the robot drove, a dot and the time every second, and its body at the contact.
  void draw_robot(SvgWriter& svg) const {
    std::vector<possible::TimedPlace> all, near;
    for (const RecordedMoment& moment : moments_) {
      all.push_back({moment.time, moment.X_MB.position()});
      if (moment.time >= from_ - 1e-6 && moment.time <= time_ + 1e-6) near.push_back(all.back());
    }
    near.push_back({time_, pose_at(moments_, time_).position()});
    draw_line(svg, all, {{"class", "drive"}, {"stroke", "#8b98a6"}, {"stroke-width", "1.6"}});
    draw_line(svg, near,
              {{"class", "robot"},
               {"stroke", std::string(kRobot)},
               {"stroke-width", "3.5"},
               {"stroke-linecap", "round"}});
    draw_seconds(svg, near, std::string(kRobot), true);
    draw_body(svg, pose_at(moments_, time_), std::string(kRobot), "");
  }

  /// The latest state from which a motion is known, and that motion.
  void draw_way_out(SvgWriter& svg) const {
    if (motion_ == nullptr || motion_->empty()) return;
    const std::string color(kWayOut);
    std::vector<possible::TimedPlace> way;
    for (const possible::MotionState& state : *motion_) way.push_back({state.time, state.pose.position()});
    draw_line(svg, way,
              {{"class", "way-out"}, {"stroke", color}, {"stroke-width", "3"}, {"stroke-dasharray", "7 4"}});
    draw_seconds(svg, way, color, true);
    draw_body(svg, motion_->front().pose, color, "5 3");
    draw_body(svg, motion_->back().pose, color, "5 3");
    const Vector2 at = view_(motion_->front().pose.position());
    label(svg, at, at + aside(), "avoidable until " + fixed(motion_->front().time, 1) + " s", color);
  }

  /// Centre of who is touched, at the contact; the robot's where nobody knows.
  Vector2 touched_person() const {
    Vector2 person = pose_at(moments_, time_).position();
    double nearest = 1e9;
    for (const possible::TimedPlace& place :
         way_of(moments_, picture_.contact->record.person, time_ - 0.3, time_ + 0.3)) {
      if (std::abs(place.time - time_) >= nearest) continue;
      nearest = std::abs(place.time - time_);
      person = place.position;
    }
    return person;
  }

  /// From a place to its label on the page: up or down, on the side that is across the line from the robot to who is touched and away
  /// from where the robot came from. Labels are wide, and beside a body they would cover others.
  Vector2 aside() const {
    const Vector2 robot = view_(pose_at(moments_, time_).position());
    const Vector2 towards = view_(touched_person()) - robot;
    const Vector2 back = view_(pose_at(moments_, time_ - 1.0).position()) - robot;
    Vector2 across(-towards.y(), towards.x());
    if (across.dot(back) > 0.0) across = -across;
    const double way = 1.5 * recording_.robot.radius * view_.scale + kLabelWay;
    return {0.0, across.y() > 0.0 ? way : -way};
  }

  void draw_contact(SvgWriter& svg) const {
    if (!picture_.contact) return;
    const Vector2 robot = pose_at(moments_, time_).position();
    const Vector2 touch = view_(robot + 0.5 * (touched_person() - robot));
    svg.circle(touch, 6,
               style({{"class", "contact"},
                      {"fill", std::string(kAlarm)},
                      {"stroke", "#ffffff"},
                      {"stroke-width", "2"}}));
    label(svg, touch, touch - aside(), "contact " + fixed(time_, 2) + " s", std::string(kAlarm));
  }

  void draw_line(SvgWriter& svg, const std::vector<possible::TimedPlace>& way,
                 std::vector<std::pair<std::string_view, std::string>> look) const {
    if (way.size() < 2) return;
    std::vector<Vector2> points;
    for (const possible::TimedPlace& place : way) points.push_back(view_(place.position));
    std::string text = style({{"stroke-linejoin", "round"}});
    for (const auto& [name, value] : look) text += style({{name, value}});
    svg.polyline(points, text);
  }

  /// A dot each whole second, with its number where that is not too near to the one before.
  void draw_seconds(SvgWriter& svg, const std::vector<possible::TimedPlace>& way, const std::string& color,
                    bool is_numbered) const {
    std::optional<Vector2> numbered;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const double second = std::ceil(way[i].time - 1e-6);
      if (second >= way[i + 1].time - 1e-6) continue;
      const double share = std::clamp((second - way[i].time) / (way[i + 1].time - way[i].time), 0.0, 1.0);
      const Vector2 at = view_(way[i].position + share * (way[i + 1].position - way[i].position));
      svg.circle(at, is_numbered ? 4.0 : 2.6, fill(color));
      if (!is_numbered || (numbered && (*numbered - at).norm() < 18.0)) continue;
      svg.text(at + Vector2(7, -6), fixed(second, 0),
               label_style(color, 13, "start", 600) +
                   "paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"");
      numbered = at;
    }
  }

  void draw_body(SvgWriter& svg, const Pose2& pose, const std::string& color,
                 const std::string& dashes) const {
    std::string look =
        style({{"fill", color}, {"fill-opacity", "0.10"}, {"stroke", color}, {"stroke-width", "2"}});
    if (!dashes.empty()) look += style({{"stroke-dasharray", dashes}});
    draw_footprint(svg, view_, recording_.robot, pose, look);
    const Vector2 at = view_(pose.position());
    const Vector2 front = view_(pose * Vector2(front_of(recording_.robot), 0.0));
    if (front.allFinite())
      svg.line(at + (front - at) * 0.5, front, style({{"stroke", color}, {"stroke-width", "3"}}));
  }

  /// A text beside a place, kept on the page.
  void label(SvgWriter& svg, const Vector2& of, Vector2 at, const std::string& text,
             const std::string& color) const {
    const double half = 4.2 * static_cast<double>(text.size()) + 10.0;
    at.x() = std::clamp(at.x(), view_.corner.x() + half + 4, view_.corner.x() + view_.width() - half - 4);
    at.y() = std::clamp(at.y(), view_.corner.y() + 16, view_.corner.y() + view_.height() - 16);
    svg.line(of, at, style({{"stroke", color}, {"stroke-width", "1"}}));
    svg.rectangle(at - Vector2(half, 12), 2 * half, 24,
                  style({{"rx", "12"}, {"fill", "#ffffff"}, {"stroke", color}, {"stroke-width", "1.3"}}));
    svg.text(at + Vector2(0, 5), text, label_style(color, 13, "middle", 600));
  }

  void draw_header(SvgWriter& svg) const {
    svg.text({kMargin, 30}, picture_.title, label_style(kInk, 20, "start", 700));
    double y = 52.0;
    for (const std::string& line : picture_.lines) {
      svg.text({kMargin, y}, line, label_style(kSoftInk, 14));
      y += kLineHeight;
    }
  }

  void draw_legend(SvgWriter& svg) const {
    const double y = view_.corner.y() + view_.height() + 28.0;
    draw_scale_bar(svg, view_, {kMargin, y});
    double x = kMargin + 220.0;
    const auto entry = [&](std::string_view color, std::string_view dashes, std::string_view text,
                           double width) {
      svg.line({x, y}, {x + 26, y},
               style({{"stroke", std::string(color)},
                      {"stroke-width", "3"},
                      {"stroke-dasharray", std::string(dashes)}}));
      svg.text({x + 33, y + 5}, text, label_style(kSoftInk, 13));
      x += width;
    };
    entry(kRobot, "none", "robot, a dot each second", 205);
    if (picture_.contact) entry(kAlarm, "none", "who is touched", 140);
    entry(kPeople, "none", "others, last 4 s", 145);
    if (motion_ != nullptr && !motion_->empty()) entry(kWayOut, "7 4", "a motion without contact", 0);
  }

  const RunRecording& recording_;
  const Moments& moments_;
  const FailurePicture& picture_;
  double header_;  ///< [px]
  double time_ = 0.0;
  double from_ = 0.0;  ///< the robot's way stands out from here on [s]
  const std::vector<possible::MotionState>* motion_ = nullptr;
  PictureView view_;
};

}  // namespace

std::string failure_picture(const RunRecording& recording, const FailurePicture& picture) {
  return Drawing(recording, picture).text();
}

}  // namespace bw
