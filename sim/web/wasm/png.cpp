// Replaces sim/pictures with a fast PNG writer.
#include <array>
#include <cstdint>

#include "sim/pictures/encode.h"
#include "sim/web/wasm/deflate.h"

namespace csgsim::pictures {

namespace {

constexpr std::array<std::uint32_t, 256> make_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = value >> 1U ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    table[i] = value;
  }
  return table;
}

/// The CRC of PNG's Annex D.
std::uint32_t crc32(std::string_view bytes) {
  constexpr std::array<std::uint32_t, 256> table = make_table();
  std::uint32_t value = ~0U;
  for (const char byte : bytes) value = value >> 8U ^ table[(value ^ static_cast<unsigned char>(byte)) & 0xFFU];
  return ~value;
}

void put_number(std::uint32_t number, std::string& bytes) {
  for (unsigned shift = 32; shift > 0; shift -= 8) bytes.push_back(static_cast<char>(number >> (shift - 8) & 0xFFU));
}

void put_chunk(std::string_view type, std::string_view data, std::string& file) {
  put_number(static_cast<std::uint32_t>(data.size()), file);
  const std::size_t begin = file.size();
  file.append(type).append(data);
  put_number(crc32(std::string_view(file).substr(begin)), file);
}

/// The rows, each with its filter byte: `sub`, the difference from the pixel to the left, turns pixels of one colour
/// into zeros.
std::string rows_of(const Raster& raster, Bytes bytes) {
  constexpr char sub = 1;
  const auto pixel = static_cast<std::size_t>(raster.channels);
  const std::size_t length = raster.width * pixel;
  std::string rows((length + 1) * raster.height, sub);
  auto* to = reinterpret_cast<std::uint8_t*>(rows.data());
  for (std::size_t y = 0; y < raster.height; ++y) {
    const Bytes row = bytes.subspan(y * length, length);
    ++to;
    for (std::size_t i = 0; i < length; ++i)
      *to++ = static_cast<std::uint8_t>(row[i] - (i < pixel ? 0 : row[i - pixel]));
  }
  return rows;
}

}  // namespace

std::string encode(const std::filesystem::path& path, const Raster& raster) {
  const auto* const bytes = std::get_if<Bytes>(&raster.samples);
  if (bytes == nullptr) throw InputError(path.native() + ": a page in a browser can only write pictures of bytes");
  std::string header;
  put_number(raster.width, header);
  put_number(raster.height, header);
  const char colour_type = raster.channels == 1 ? 0 : 2;
  header.append({8, colour_type, 0, 0, 0});
  std::string file("\x89PNG\r\n\x1A\n");
  put_chunk("IHDR", header, file);
  put_chunk("IDAT", web::compress_zlib(rows_of(raster, *bytes)), file);
  put_chunk("IEND", {}, file);
  return file;
}

}  // namespace csgsim::pictures
