#include "sim/web/wasm/deflate.h"

#include <png.h>

#include "sim/pictures/encode.h"
#include "tests/support/inflated.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::vector<std::uint8_t> random_bytes(std::size_t count) {
  std::mt19937 generator(3);
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(generator());
  return bytes;
}

/// Returns the pixels as libpng reads them from a file in memory.
std::vector<std::uint8_t> pixels_of(const std::string& file, std::uint32_t format, png_image& image) {
  image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = format;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

}  // namespace

TEST_CASE("zlib inflates the output of web::compress_zlib() to the original bytes") {
  for (const std::size_t count : {0U, 1U, 5551U, 5553U, 65535U, 65536U, 200'000U}) {
    CAPTURE(count);
    const std::vector<std::uint8_t> random = random_bytes(count);
    const std::string bytes(random.begin(), random.end());
    CHECK(testing::inflated(web::compress_zlib(bytes), count) == bytes);
  }
}

TEST_CASE("web::compress_zlib() packs two runs of up to 1199 bytes into less than 40 bytes") {
  for (std::size_t length = 0; length < 1200; ++length) {
    CAPTURE(length);
    const std::string bytes = "a" + std::string(length, '\xC8') + "b" + std::string(length, '\0');
    const std::string packed = web::compress_zlib(bytes);
    CHECK(testing::inflated(packed, bytes.size()) == bytes);
    CHECK(packed.size() < 40);
  }
}

TEST_CASE("libpng reads the grey and colour PNG files that the web build encodes") {
  for (const int channels : {1, 3}) {
    CAPTURE(channels);
    const std::vector<std::uint8_t> bytes = random_bytes(std::size_t{301} * 97 * static_cast<std::size_t>(channels));
    const std::string file = pictures::encode("picture.png", {301, 97, channels, {}, pictures::Bytes(bytes)});
    png_image image;
    CHECK(pixels_of(file, channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB, image) == bytes);
    CHECK(image.width == 301);
    CHECK(image.height == 97);
  }
}
