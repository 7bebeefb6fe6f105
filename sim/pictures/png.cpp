#include "sim/pictures/png.h"

#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>

namespace csgsim::pictures {

namespace {

/// Output of libpng. It is C code, so no exception may pass through it.
struct Sink {
  std::string bytes;
  char error[128] = "";  // NOLINT(modernize-avoid-c-arrays)
};

extern "C" [[noreturn]] void png_failed(png_structp png, png_const_charp message) {
  auto* const sink = static_cast<Sink*>(png_get_error_ptr(png));
  std::snprintf(&sink->error[0], sizeof sink->error, "%s", message);
  png_longjmp(png, 1);
}

extern "C" void ignore_png_warning(png_structp /*png*/, png_const_charp /*message*/) {}

bool append(std::string& bytes, const png_byte* data, std::size_t length) {
  try {
    bytes.append(reinterpret_cast<const char*>(data), length);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

extern "C" void take_png_bytes(png_structp png, png_bytep data, std::size_t length) {
  if (!append(static_cast<Sink*>(png_get_io_ptr(png))->bytes, data, length)) png_error(png, "not enough memory");
}

extern "C" void flush_nothing(png_structp /*png*/) {}

/// Pictures have areas of one colour. Without filters these are runs of equal bytes, which take less time and space
/// than the differences that libpng would choose row by row. At zlib level 4 a file is about as long as with libpng's
/// defaults, in a quarter of the time.
constexpr int filters = PNG_FILTER_NONE;
constexpr int level = 4;

/// Needs no destructors: libpng leaves the function by a jump on errors.
bool write_png(png_structp png, png_infop info, const Raster& raster, Bytes bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way to report errors
  png_set_filter(png, PNG_FILTER_TYPE_BASE, filters);
  png_set_compression_level(png, level);
  png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
  png_set_IHDR(png, info, raster.width, raster.height, 8,
               raster.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
  png_write_info(png, info);
  const std::size_t row = std::size_t{raster.width} * static_cast<std::size_t>(raster.channels);
  for (std::uint32_t y = 0; y < raster.height; ++y) png_write_row(png, &bytes[y * row]);
  png_write_end(png, info);
  return true;
}

}  // namespace

Encoded encode_png(const Raster& raster, Bytes bytes) {
  Sink sink;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, png_failed, ignore_png_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) {
    png_destroy_write_struct(&png, nullptr);
    throw std::bad_alloc();
  }
  png_set_write_fn(png, &sink, take_png_bytes, flush_nothing);
  const bool written = write_png(png, info, raster, bytes);
  png_destroy_write_struct(&png, &info);
  if (!written) return {{}, &sink.error[0]};
  return {std::move(sink.bytes), {}};
}

}  // namespace csgsim::pictures
