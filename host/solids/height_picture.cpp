#include "host/solids/height_picture.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>

#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// The input of libpng. libpng is C code, so its callbacks must not throw.
struct Stream {
  std::string_view bytes;
  char error[128] = "";  // NOLINT(modernize-avoid-c-arrays)
};

extern "C" [[noreturn]] void height_picture_failed(png_structp png, png_const_charp message) {
  auto* const stream = static_cast<Stream*>(png_get_error_ptr(png));
  std::snprintf(&stream->error[0], sizeof stream->error, "%s", message);
  png_longjmp(png, 1);
}

extern "C" void height_picture_warned(png_structp /*png*/, png_const_charp /*message*/) {}

extern "C" void read_png_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* const stream = static_cast<Stream*>(png_get_io_ptr(png));
  if (count > stream->bytes.size()) png_error(png, "the file ends too early");
  std::memcpy(to, stream->bytes.data(), count);
  stream->bytes.remove_prefix(count);
}

/// Holds no object with a destructor, because libpng reports errors by longjmp.
bool read_header(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng reports errors this way
  png_read_info(png, info);
  png_set_strip_16(png);
  png_set_packing(png);
  png_set_expand(png);
  png_set_strip_alpha(png);
  png_set_gray_to_rgb(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

/// Like read_header(), holds no object with a destructor.
bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

/// Frees libpng's structures.
struct Reader {
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit Reader(Stream& stream)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, height_picture_failed, height_picture_warned)) {
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

}  // namespace

Pixels read_png(std::string_view bytes, std::string_view name, std::size_t max_pixels) {
  Stream stream{bytes};
  const Reader reader(stream);
  const auto fail = [&] {
    throw InputError(fmt::format("{}: not a PNG file, or damaged ({}); save it again", name, &stream.error[0]));
  };
  if (reader.info == nullptr) throw InputError("not enough memory to read a picture");
  png_set_read_fn(reader.png, &stream, read_png_bytes);
  if (!read_header(reader.png, reader.info)) fail();
  Pixels pixels{png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info), {}};
  if (std::uint64_t{pixels.width} * pixels.height > max_pixels) {
    throw InputError(fmt::format("{}: the picture has more than {} pixels; scale it down", name, max_pixels));
  }
  const std::size_t row = std::size_t{3} * pixels.width;
  pixels.bytes.resize(row * pixels.height);
  std::vector<png_bytep> rows;
  for (std::uint32_t y = 0; y < pixels.height; ++y) rows.push_back(&pixels.bytes[y * row]);
  if (png_get_rowbytes(reader.png, reader.info) != row || !read_rows(reader.png, rows.data())) fail();
  return pixels;
}

}  // namespace csgsim::solids
