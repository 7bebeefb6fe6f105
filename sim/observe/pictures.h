#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "hw/base/output_file.h"
#include "sim/observe/frame.h"

namespace csgsim::observe {

/// Throws InputError unless the path's extension names a format for pictures; a stream without one is PNG, or EXR for
/// distances. Asked before a run, it lets what takes
/// long to load be loaded beside the run.
void check_format(const std::filesystem::path& path);

/// The same for a picture of distances.
void check_depth_format(const std::filesystem::path& path);

/// The picture, 8 bits a channel, in the format that the file's extension names. Throws InputError.
void write_picture(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Distances from the eye along the view axis in model units, one float channel Z, infinite where nothing is seen
/// (EXR).
void write_depth(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Whether an owner picture of that name has colours, of which a legend tells (PNG), or else indices (EXR).
bool has_legend(const std::filesystem::path& owner_picture);

/// Who is seen at each pixel. EXR: the primitive's index, one float channel `owner`, -1 where nothing is seen. PNG: its
/// colour, see owner_colour.
void write_owner(OutputFile& file, const Frame& frame);

/// The frame with primitives as owners, in place of their pieces.
Frame of_primitives(Frame frame, const isa::Facts& facts);

/// The colour of a primitive, 8 bits a channel, in an owner picture; black for no_owner. Those of indices below 2^24 -
/// 1 are all different: the bits of the index + 1 go to red, green and blue in turn, the lowest three into the highest
/// bit of each, so that primitives with near indices have colours far apart (the colour map of the PASCAL VOC
/// challenge).
std::array<std::uint8_t, 3> owner_colour(std::uint32_t primitive);

/// The legend of an owner picture, .json: colour, index, name and pixels of each primitive, and of nothing.
void write_legend(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Bytes of a picture that is no frame: `channels` a pixel, 1 for grey or 3, in row order.
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 1;
  std::vector<std::uint8_t> bytes;
};

/// In the format that the file's extension names. Throws InputError.
void write_picture(OutputFile& file, const Picture& picture);

}  // namespace csgsim::observe
