#pragma once

#include <filesystem>

#include "hw/base/output_file.h"
#include "sim/observe/frame.h"

namespace csgsim::sim {

/// Throws InputError unless the path's extension names a format for pictures.
void check_format(const std::filesystem::path& path);

/// The picture, 8 bits a channel, in the format that the file's extension names. Throws InputError.
void write_picture(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Distances from the eye along the view axis in model units, one float channel Z, infinite where nothing is seen
/// (EXR).
void write_depth(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Index of the primitive seen at each pixel, one float channel `owner`, -1 where nothing is seen (EXR).
void write_owner(OutputFile& file, const Frame& frame);

}  // namespace csgsim::sim
