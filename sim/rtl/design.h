#pragma once

#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// A file of a design's folder.
struct DesignFile {
  std::string path;  ///< in the folder
  std::string content;
};

/// The machine in Verilog with a testbench, a Makefile, constraints of boards and a README: with the Program in a
/// memory beside it, or, without one (null), with a serial line in its place. Throws InputError as parameters_of does,
/// and for a Program that shows no picture.
std::vector<DesignFile> design_files(const machines::Machine& machine, const isa::Program* program);

}  // namespace csgsim::rtl
