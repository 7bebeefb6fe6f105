// Taps of the fields of a pixel.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// Part name `pixel_X_Y` under which the taps of a probed pixel are listed.
std::string pixel_part_name(Pixel pixel);

/// One tap `PART.FIELD` per named field of a pixel's memory: fields of one bit as bits, depths as numbers, others in
/// hexadecimal. `read` returns the value of a field; empty if it is not available.
std::vector<Tap> field_taps(const std::string& part, const isa::Program& program,
                            const std::function<Number(isa::Field)>& read);

}  // namespace csgsim::wave
