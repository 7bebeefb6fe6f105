// Common parts of the streams that encode a display model.
// Used by hw/multi_processor.
#pragma once

#include "hw/division/bit_stream.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// The size of the picture, and the numbers of bits of depth, fraction and colour.
void put_sampling(BitWriter& out, const DisplayModel& model);
void take_sampling(BitReader& in, DisplayModel& model);

void put_fields(BitWriter& out, const Fields& fields);
Fields take_fields(BitReader& in, unsigned z_bits, unsigned colour_bits);

/// `depth_bits`: width of a depth step or of the end of the range. Limits are stored plus one, so that an empty range
/// is stored as 0 to 0.
void put_box(BitWriter& out, const Box& box, unsigned depth_bits);
Box take_box(BitReader& in, unsigned depth_bits);

}  // namespace csgsim::division
