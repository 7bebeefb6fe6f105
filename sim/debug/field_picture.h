#pragma once

#include <string>

#include "sim/engine/run.h"
#include "sim/observe/pictures.h"

namespace csgsim::debug {

/// A field, or E for one of width 0, of every pixel of the run's segment; pixels of the rest of the picture are black.
struct FieldPicture {
  observe::Picture picture;
  std::string scale;  ///< what black and white stand for
};

/// Colours in colour. Other numbers in grey, from the least to the greatest that occur; of depths, all ones, which is
/// nothing, is white and does not count.
FieldPicture picture_of(isa::Field field, const engine::Run& run, const isa::Program& program);

}  // namespace csgsim::debug
