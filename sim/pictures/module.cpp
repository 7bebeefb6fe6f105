#include "sim/pictures/module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <string_view>

namespace csgsim::pictures {

namespace {

std::unique_ptr<OIIO::ImageOutput> writer_for(const char* path) {
  std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(path);
  if (!writer) {
    OIIO::geterror();  // clears the message, which is not used
    return nullptr;
  }
  const std::string_view format = writer->format_name();
  if (format == "null" || format == "term") return nullptr;  // these formats create no file
  return writer;
}

Target target_for(const char* path) {
  const std::unique_ptr<OIIO::ImageOutput> writer = writer_for(path);
  if (!writer) return Target::none;
  return writer->supports("ioproxy") != 0 ? Target::memory : Target::file;
}

OIIO::ImageSpec specify(const Raster& raster, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(static_cast<int>(raster.width), static_cast<int>(raster.height), raster.channels, type);
  spec.attribute("DateTime", "");
  if (!raster.channel.empty()) spec.channelnames = {raster.channel};
  return spec;
}

bool write(OIIO::ImageOutput& writer, const char* name, const Raster& raster) {
  const auto* const bytes = std::get_if<Bytes>(&raster.samples);
  const OIIO::TypeDesc type = bytes != nullptr ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  const void* const samples = bytes != nullptr ? static_cast<const void*>(bytes->data())
                                               : static_cast<const void*>(std::get<Floats>(raster.samples).data());
  return writer.open(name, specify(raster, type)) && writer.write_image(type, samples) && writer.close();
}

Encoded encode(const char* path, const char* file, const Raster& raster) {
  const std::unique_ptr<OIIO::ImageOutput> writer = writer_for(path);
  if (!writer) return {{}, "unknown format"};
  OIIO::Filesystem::IOVecOutput buffer;
  if (file == nullptr) writer->set_ioproxy(&buffer);
  if (!write(*writer, file == nullptr ? path : file, raster)) return {{}, writer->geterror()};
  return {{reinterpret_cast<const char*>(buffer.buffer().data()), buffer.buffer().size()}, {}};
}

}  // namespace

}  // namespace csgsim::pictures

// The name must equal module_symbol.
extern "C" [[gnu::visibility("default")]] const csgsim::pictures::Module csgsim_pictures_1;
const csgsim::pictures::Module csgsim_pictures_1{csgsim::pictures::target_for, csgsim::pictures::encode};
