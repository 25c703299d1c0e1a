#include "components/lab/bench/buildings/building.hpp"

#include <stdexcept>

#include "components/lab/bench/buildings/floor_plan.hpp"

namespace bw::buildings {
namespace {

// The layout must not share its draws with the noises of a drive that has the same seed.
constexpr std::uint64_t kLayoutStream = 0x94d049bb133111eb;

FloorPlan plan_of(BuildingKind kind, Random& random) {
  switch (kind) {
    case BuildingKind::office:
      return plan_office(random, 0);
    case BuildingKind::corridors:
      return plan_corridors(random);
    case BuildingKind::loop:
      return plan_loop(random);
    case BuildingKind::pillars:
      return plan_pillars(random);
    case BuildingKind::warehouse:
      return plan_warehouse(random);
    case BuildingKind::campus:
      return plan_campus(random);
  }
  throw std::invalid_argument("no such kind of building");
}

}  // namespace

const char* to_text(BuildingKind kind) {
  switch (kind) {
    case BuildingKind::office:
      return "office";
    case BuildingKind::corridors:
      return "corridors";
    case BuildingKind::loop:
      return "loop";
    case BuildingKind::pillars:
      return "pillars";
    case BuildingKind::warehouse:
      return "warehouse";
    case BuildingKind::campus:
      return "campus";
  }
  return "unknown";
}

Building make_building(BuildingKind kind, std::uint64_t seed) {
  Random random(seed ^ kLayoutStream);
  Building building = build(plan_of(kind, random), random);
  building.name = std::string(to_text(kind)) + " " + std::to_string(seed);
  return building;
}

Building make_office(std::uint64_t seed, std::uint64_t arrangement) {
  Random random(seed ^ kLayoutStream);
  Building building = build(plan_office(random, arrangement), random);
  building.name = std::string(to_text(BuildingKind::office)) + " " + std::to_string(seed);
  return building;
}

}  // namespace bw::buildings
