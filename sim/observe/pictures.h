// Writes pictures, depths and owners to files.
// Used throughout sim.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "hw/base/output_file.h"
#include "sim/observe/frame.h"

namespace csgsim::observe {

/// Throws InputError unless the path's extension names a picture format; a stream without extension is PNG, or EXR for
/// distances. A call before the run starts loading slow libraries in parallel with it.
void check_format(const std::filesystem::path& path);

/// Throws InputError unless the path's extension names a format for distances; a stream without extension is EXR.
void check_depth_format(const std::filesystem::path& path);

/// The picture's red, green and blue, 8 bits each, in row order.
std::vector<std::uint8_t> rgb_bytes(const Frame& frame, const isa::Program& program);

/// Writes the picture with 8 bits per channel, in the format of the file's extension. Throws InputError.
void write_picture(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Writes distances from the eye along the view axis in model units, as one float channel Z, infinite where nothing is
/// visible (EXR).
void write_depth(OutputFile& file, const Frame& frame, const isa::Program& program);

/// Whether an owner picture of that name has colours and a legend (PNG), rather than indices (EXR).
bool has_legend(const std::filesystem::path& owner_picture);

/// Writes the owner of each pixel. EXR: the primitive's index, as one float channel `owner`, -1 where nothing is
/// visible. PNG: its colour, see owner_colour.
void write_owner(OutputFile& file, const Frame& frame);

/// The frame with each owner, a piece, replaced by the primitive to which the piece belongs.
Frame with_primitive_owners(Frame frame, const isa::Facts& facts);

/// The colour of a primitive in an owner picture, 8 bits per channel; black for no_owner. Indices below 2^24 - 1 have
/// different colours: the bits of index + 1 go to red, green and blue in turn, the lowest three into the highest bit of
/// each, so that neighbouring indices get very different colours (the colour map of the PASCAL VOC challenge).
std::array<std::uint8_t, 3> owner_colour(std::uint32_t primitive);

/// Writes the legend of an owner picture, .json: colour, index, name and pixel count of each primitive, and of nothing.
void write_legend(OutputFile& file, const Frame& frame, const isa::Program& program);

/// A picture that is not a frame: `channels` bytes per pixel, 1 for grey or 3, in row order.
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 1;
  std::vector<std::uint8_t> bytes;
};

/// Writes the picture in the format of the file's extension. Throws InputError.
void write_picture(OutputFile& file, const Picture& picture);

}  // namespace csgsim::observe
