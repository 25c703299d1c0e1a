// What each cluster of a training room truly is.
#pragma once

#include <vector>

#include "components/lab/people_training/training_room.hpp"
#include "components/people/detector/detector.hpp"

namespace bw::people {

enum class Kind : std::uint8_t {
  other,  ///< no point on anybody
  leg,    ///< four fifths of the points on one leg
  body,   ///< four fifths of the points on one person, not on one leg
  mixed   ///< several people, or a person with furniture
};

struct Label {
  Kind kind = Kind::other;
  int leg = -1;  ///< index into RoomSweep::legs of the leg with most points; leg / 2 is the person
  Piece piece = Piece::wall;  ///< what it is, of the kind other
};

/// For each cluster of the detector's last sweep, which must be that of the room.
std::vector<Label> label_clusters(const TrainingRoom& room, const RoomSweep& sweep, const Detector& detector);

/// How many beams end on each person of the room, and how many would if nothing stood before them.
struct Visibility {
  int seen = 0;
  int expected = 0;
};
std::vector<Visibility> visibility(const RoomSweep& sweep, const Detector& detector);

}  // namespace bw::people
