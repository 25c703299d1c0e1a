// The program `bandwagon`: what a robot runs, and how people look at it.
#include <cstddef>

#include "components/program/lab.hpp"
#include "components/program/program.hpp"

int main(int argc, char** argv) {
  if (bw::is_for_lab({argv, static_cast<std::size_t>(argc)})) return bw::become_lab(argv);
  return bw::run_program("bandwagon", "Drives wheeled robots among people", argc, argv);
}
