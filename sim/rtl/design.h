// Generates a Verilog design.
// Used by sim/app.
#pragma once

#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// A file in the folder of a design.
struct DesignFile {
  std::string path;  ///< relative to the folder
  std::string content;
};

/// The machine in Verilog with a testbench, a Makefile, board constraints and a README. The Program is stored in a
/// memory beside the machine; without a Program (null), the design has a serial line instead. Throws InputError like
/// verilog_parameters, and for a Program without a picture.
std::vector<DesignFile> design_files(const machines::Machine& machine, const isa::Program* program);

}  // namespace csgsim::rtl
