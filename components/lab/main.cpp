// The program `bandwagon-lab`: planners compared, tables made again, logs imported.
#include "components/program/program.hpp"

int main(int argc, char** argv) {
  return bw::run_program("bandwagon-lab", "Compares planners, makes published tables again, imports logs",
                         argc, argv);
}
