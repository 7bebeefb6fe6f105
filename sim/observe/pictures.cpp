#include "sim/observe/pictures.h"

#include <OpenImageIO/imageio.h>

#include <array>
#include <string>

#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/error.h"

namespace csgsim::sim {

namespace {

[[noreturn]] void throw_no_format(const std::filesystem::path& path) {
  OIIO::geterror();  // takes the message away, which nobody asked for
  throw InputError(path.string() + ": no picture format for this name; end it in .png, .tif, .ppm, .exr or the like");
}

OIIO::ImageSpec specify(const Frame& frame, int channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), channels, type);
  // The same picture is the same file, whenever it is written.
  spec.attribute("DateTime", "");
  return spec;
}

void write(const OutputFile& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
  const std::string path = file.path().string();
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) throw_no_format(file.asked());
  if (!output->open(path, spec) || !output->write_image(type, pixels) || !output->close()) {
    throw InputError(file.asked().string() + ": cannot be written: " + output->geterror());
  }
}

}  // namespace

void check_format(const std::filesystem::path& path) {
  if (!OIIO::ImageOutput::create(path.string())) throw_no_format(path);
}

void write_picture(const OutputFile& file, const Frame& frame, const isa::Program& program) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(frame.colour.size() * 3);
  const unsigned bits = isa::field_of(program, isa::FieldRole::colour).width;
  for (const std::uint32_t colour : frame.colour) {
    const std::array<std::uint8_t, 3> channels = isa::unpack_colour(colour, bits);
    pixels.insert(pixels.end(), channels.begin(), channels.end());
  }
  write(file, specify(frame, 3, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8, pixels.data());
}

void write_depth(const OutputFile& file, const Frame& frame, const isa::Program& program) {
  std::vector<float> pixels;
  pixels.reserve(frame.depth.size());
  const unsigned bits = isa::field_of(program, isa::FieldRole::depth).width;
  for (const std::uint32_t step : frame.depth) {
    pixels.push_back(static_cast<float>(isa::distance_of(program.depth_scale, bits, step)));
  }
  OIIO::ImageSpec spec = specify(frame, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"Z"};
  write(file, spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

void write_owner(const OutputFile& file, const Frame& frame) {
  std::vector<float> pixels;
  pixels.reserve(frame.owner.size());
  for (const std::uint32_t owner : frame.owner) pixels.push_back(owner == no_owner ? -1.0F : static_cast<float>(owner));
  OIIO::ImageSpec spec = specify(frame, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"owner"};
  write(file, spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

}  // namespace csgsim::sim
