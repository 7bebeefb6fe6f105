#pragma once

#include <string>

#include "hw/isa/program.h"
#include "sim/observe/frame.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// A frame as it is shown.
Picture picture_of(const observe::Frame& frame, const isa::Program& program, std::string caption, std::string alt);

/// Which primitive is seen, a colour each (observe::owner_colour). Owners are primitives (observe::of_primitives).
Picture owners_of(const observe::Frame& frame, std::string caption, std::string alt);

}  // namespace csgsim::report
