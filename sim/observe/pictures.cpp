#include "sim/observe/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string>

#include "hw/base/pages.h"
#include "hw/base/text.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "sim/pictures/encode.h"

namespace csgsim::observe {

namespace {

/// A one-channel picture; `channel` is its name in formats that name channels.
pictures::Raster floats(const Frame& frame, const std::string& channel, const std::vector<float>& samples) {
  return {frame.width, frame.height, 1, channel, pictures::Floats(samples)};
}

pictures::Raster colours(const Frame& frame, const std::vector<std::uint8_t>& samples) {
  return {frame.width, frame.height, 3, {}, pictures::Bytes(samples)};
}

/// The name, with the default extension if it has none that selects a format.
std::filesystem::path with_default_extension(std::filesystem::path path, const char* usual_ending) {
  return path.has_extension() || !is_stream(path) ? path : path += usual_ending;
}

constexpr const char* png = ".png";
constexpr const char* exr = ".exr";

void write(OutputFile& file, const char* usual_ending, const pictures::Raster& raster) {
  file.write(pictures::encode(with_default_extension(file.requested(), usual_ending), raster));
}

}  // namespace

void check_format(const std::filesystem::path& path) {
  pictures::check_format(with_default_extension(path, png), pictures::Samples::bytes);
}

void check_depth_format(const std::filesystem::path& path) {
  pictures::check_format(with_default_extension(path, exr), pictures::Samples::floats);
}

std::vector<std::uint8_t> rgb_bytes(const Frame& frame, const isa::Program& program) {
  auto pixels = filled<std::uint8_t>(frame.colour.size() * 3, 0);
  const unsigned bits = program.colour.width;
  std::uint32_t last = 0;  // neighbouring pixels are mostly equal
  std::array<std::uint8_t, 3> channels = isa::unpack_colour(last, bits);
  auto to = pixels.begin();
  for (const std::uint32_t colour : frame.colour) {
    if (colour != last) channels = isa::unpack_colour(last = colour, bits);
    to = std::ranges::copy(channels, to).out;
  }
  return pixels;
}

void write_picture(OutputFile& file, const Frame& frame, const isa::Program& program) {
  write(file, png, colours(frame, rgb_bytes(frame, program)));
}

void write_depth(OutputFile& file, const Frame& frame, const isa::Program& program) {
  std::vector<float> pixels;
  pixels.reserve(frame.depth.size());
  const unsigned bits = isa::find_field(program, isa::FieldRole::depth).width;
  for (const std::uint32_t step : frame.depth) {
    pixels.push_back(static_cast<float>(isa::distance_of(program.facts->depth_scale, bits, step)));
  }
  write(file, exr, floats(frame, "Z", pixels));
}

bool has_legend(const std::filesystem::path& owner_picture) {
  std::string extension = with_default_extension(owner_picture, png).extension().native();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".png";
}

std::array<std::uint8_t, 3> owner_colour(std::uint32_t primitive) {
  std::array<std::uint8_t, 3> colour{};
  if (primitive == no_owner) return colour;
  std::uint32_t left = primitive + 1;
  for (unsigned bit = 0x80U; bit != 0; bit >>= 1U) {
    for (std::uint8_t& channel : colour) {
      if ((left & 1U) != 0) channel = static_cast<std::uint8_t>(channel | bit);
      left >>= 1U;
    }
  }
  return colour;
}

namespace {

void write_owner_colours(OutputFile& file, const Frame& frame) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(frame.owner.size() * 3);
  for (const std::uint32_t owner : frame.owner) {
    const std::array<std::uint8_t, 3> colour = owner_colour(owner);
    pixels.insert(pixels.end(), colour.begin(), colour.end());
  }
  write(file, png, colours(frame, pixels));
}

nlohmann::ordered_json colour_json(std::uint32_t primitive) {
  const std::array<std::uint8_t, 3> colour = owner_colour(primitive);
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

}  // namespace

void write_owner(OutputFile& file, const Frame& frame) {
  if (has_legend(file.requested())) return write_owner_colours(file, frame);
  std::vector<float> pixels;
  pixels.reserve(frame.owner.size());
  for (const std::uint32_t owner : frame.owner) pixels.push_back(owner == no_owner ? -1.0F : static_cast<float>(owner));
  write(file, exr, floats(frame, "owner", pixels));
}

Frame with_primitive_owners(Frame frame, const isa::Facts& facts) {
  if (facts.primitive_of_piece.empty()) return frame;
  for (std::uint32_t& owner : frame.owner)
    if (owner != no_owner) owner = isa::primitive_of(facts, owner);
  return frame;
}

void write_legend(OutputFile& file, const Frame& frame, const isa::Program& program) {
  const std::vector<std::string>& names = program.facts->primitives;
  std::vector<std::uint64_t> pixels(names.size(), 0);
  std::uint64_t nothing = 0;
  for (const std::uint32_t owner : frame.owner) ++(owner < pixels.size() ? pixels[owner] : nothing);
  nlohmann::ordered_json legend{{"nothing", {{"colour", colour_json(no_owner)}, {"pixels", nothing}}},
                                {"primitives", nlohmann::ordered_json::array()}};
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    legend["primitives"].push_back(
        {{"index", i}, {"name", printable(names[i])}, {"colour", colour_json(i)}, {"pixels", pixels[i]}});
  }
  file.write(legend.dump(2) + "\n");
}

void write_picture(OutputFile& file, const Picture& picture) {
  write(file, png, {picture.width, picture.height, picture.channels, {}, pictures::Bytes(picture.bytes)});
}

}  // namespace csgsim::observe
