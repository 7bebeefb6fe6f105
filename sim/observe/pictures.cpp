#include "sim/observe/pictures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "hw/base/error.h"
#include "hw/base/memory_file.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::sim {

namespace {

[[noreturn]] void throw_no_format(const std::filesystem::path& path) {
  OIIO::geterror();  // takes the message away, which nobody asked for
  throw InputError(path.native() + ": no picture format for this name; end it in .png, .tif, .ppm, .exr or the like");
}

OIIO::ImageSpec specify(const Frame& frame, int channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), channels, type);
  // The same picture is the same file, whenever it is written.
  spec.attribute("DateTime", "");
  return spec;
}

std::unique_ptr<OIIO::ImageOutput> writer_for(const std::filesystem::path& path) {
  std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(path.native());
  if (!writer) throw_no_format(path);
  const std::string_view format = writer->format_name();
  if (format == "null" || format == "term") throw_no_format(path);  // which make no file
  return writer;
}

/// The bytes of a picture's file. They are made in memory: many formats do not tell that the disk is full.
std::string encode(const std::filesystem::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                   const void* pixels) {
  const std::unique_ptr<OIIO::ImageOutput> writer = writer_for(path);
  const auto write_to = [&](const std::string& name) {
    if (!writer->open(name, spec) || !writer->write_image(type, pixels) || !writer->close())
      throw InputError(path.native() + ": cannot be written: " + writer->geterror());
  };
  if (writer->supports("ioproxy")) {
    OIIO::Filesystem::IOVecOutput buffer;
    writer->set_ioproxy(&buffer);
    write_to(path.native());
    return {reinterpret_cast<const char*>(buffer.buffer().data()), buffer.buffer().size()};
  }
  const MemoryFile file(path);
  write_to(file.path());
  return file.content();
}

void write(OutputFile& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
  const std::string bytes = encode(file.asked(), spec, type, pixels);
  if (bytes.empty()) throw InputError(file.asked().native() + ": this format makes no file; take .png");
  file.write(bytes);
}

}  // namespace

void check_format(const std::filesystem::path& path) { writer_for(path); }

void write_picture(OutputFile& file, const Frame& frame, const isa::Program& program) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(frame.colour.size() * 3);
  const unsigned bits = isa::field_of(program, isa::FieldRole::colour).width;
  for (const std::uint32_t colour : frame.colour) {
    const std::array<std::uint8_t, 3> channels = isa::unpack_colour(colour, bits);
    pixels.insert(pixels.end(), channels.begin(), channels.end());
  }
  write(file, specify(frame, 3, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8, pixels.data());
}

void write_depth(OutputFile& file, const Frame& frame, const isa::Program& program) {
  std::vector<float> pixels;
  pixels.reserve(frame.depth.size());
  const unsigned bits = isa::field_of(program, isa::FieldRole::depth).width;
  for (const std::uint32_t step : frame.depth) {
    pixels.push_back(static_cast<float>(isa::distance_of(program.facts.depth_scale, bits, step)));
  }
  OIIO::ImageSpec spec = specify(frame, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"Z"};
  write(file, spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

void write_owner(OutputFile& file, const Frame& frame) {
  std::vector<float> pixels;
  pixels.reserve(frame.owner.size());
  for (const std::uint32_t owner : frame.owner) pixels.push_back(owner == no_owner ? -1.0F : static_cast<float>(owner));
  OIIO::ImageSpec spec = specify(frame, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"owner"};
  write(file, spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

}  // namespace csgsim::sim
