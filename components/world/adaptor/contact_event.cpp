// `contact`: the simulated robot touches a person or a wall.
#include "runtime/event.hpp"

BW_EVENT(contact, "world", "sim/ground_truth", "the robot touches somebody or something",
         {{.field = "contacts", .rule = bw::EventRule::rises}})
