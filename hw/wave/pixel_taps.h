#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// The part that a wave has for a probed pixel.
std::string part_of(Pixel pixel);

/// The named fields of a pixel's memory, `PART.FIELD` each: bits of one bit, depths as numbers, all else in
/// hexadecimal. `read` tells the field's bits, or nothing where they are not at hand.
std::vector<Tap> field_taps(const std::string& part, const isa::Program& program,
                            const std::function<Number(isa::Field)>& read);

}  // namespace csgsim::wave
