#include "components/local_planner/dwa/critics_planner.hpp"

#include <gtest/gtest.h>

namespace bw::dwa {}
