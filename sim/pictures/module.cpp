#include "sim/pictures/module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace csgsim::pictures {

namespace {

constexpr const char* gif_name = "animation.gif";

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

/// Output in memory; each call of take() removes and returns the bytes written until then.
class Taken final : public OIIO::Filesystem::IOProxy {
 public:
  Taken() : IOProxy("", IOProxy::Write) {}
  [[nodiscard]] const char* proxytype() const override { return "csgsim"; }
  std::size_t write(const void* bytes, std::size_t count) override {
    taken_.append(static_cast<const char*>(bytes), count);
    m_pos += static_cast<std::int64_t>(count);
    return count;
  }
  std::string take() { return std::exchange(taken_, {}); }

 private:
  std::string taken_;
};

class GifWriter final : public AnimationWriter {
 public:
  GifWriter(std::unique_ptr<OIIO::ImageOutput> writer, unsigned rate) : writer_(std::move(writer)), rate_(rate) {
    // OpenImageIO 2.5 takes the rate from the picture that the writer wrote before.
    writer_->set_ioproxy(&bytes_);
    if (writer_->open(gif_name, with_rate(OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::UINT8)))) writer_->close();
    bytes_.take();
    writer_->set_ioproxy(&bytes_);
  }

  Encoded add(const Raster& raster) override {
    const OIIO::ImageSpec spec = with_rate(specify(raster, OIIO::TypeDesc::UINT8));
    const auto mode = std::exchange(is_open_, true) ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create;
    const bool written = writer_->open(gif_name, spec, mode) &&
                         writer_->write_image(OIIO::TypeDesc::UINT8, std::get<Bytes>(raster.samples).data());
    return written ? Encoded{bytes_.take(), {}} : Encoded{{}, writer_->geterror()};
  }

  Encoded finish() override { return writer_->close() ? Encoded{bytes_.take(), {}} : Encoded{{}, writer_->geterror()}; }

 private:
  [[nodiscard]] OIIO::ImageSpec with_rate(OIIO::ImageSpec spec) const {
    const std::array<int, 2> rate{static_cast<int>(rate_), 1};
    spec.attribute("FramesPerSecond", OIIO::TypeRational, rate.data());
    return spec;
  }

  Taken bytes_;  // outlives the writer
  std::unique_ptr<OIIO::ImageOutput> writer_;
  unsigned rate_;
  bool is_open_ = false;
};

std::unique_ptr<AnimationWriter> animate(unsigned pictures_per_second) {
  std::unique_ptr<OIIO::ImageOutput> writer = writer_for(gif_name);
  if (!writer || writer->supports("ioproxy") == 0 || writer->supports("appendsubimage") == 0) return nullptr;
  return std::make_unique<GifWriter>(std::move(writer), pictures_per_second);
}

}  // namespace

}  // namespace csgsim::pictures

// The name must equal module_symbol.
extern "C" [[gnu::visibility("default")]] const csgsim::pictures::Module csgsim_pictures_2;
const csgsim::pictures::Module csgsim_pictures_2{csgsim::pictures::target_for, csgsim::pictures::encode,
                                                 csgsim::pictures::animate};
