// A field of every pixel as a picture.
// Used by sim/debug and sim/viewer.
#pragma once

#include <string>

#include "sim/engine/run.h"
#include "sim/observe/pictures.h"

namespace csgsim::debug {

/// A field of every pixel of the run's segment, or E for a field of width 0; the rest of the picture is black.
struct FieldPicture {
  observe::Picture picture;
  std::string scale;  ///< meaning of black and white
};

/// Colour fields are shown in colour. Other numbers are grey, scaled from the smallest to the largest occurring value;
/// in a depth field, all ones stand for the background, which is white and does not affect the scale.
FieldPicture draw_field(isa::Field field, const engine::Run& run, const isa::Program& program);

}  // namespace csgsim::debug
