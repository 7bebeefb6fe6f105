#include "sim/web/wasm/stored.h"

#include <algorithm>
#include <cstdint>

#include "sim/report/codec.h"

namespace csgsim::web {

namespace {

constexpr std::size_t longest_block = 65535;

void put_pair(std::uint32_t number, std::string& bytes) {
  bytes.push_back(static_cast<char>(number & 0xFFU));
  bytes.push_back(static_cast<char>(number >> 8U & 0xFFU));
}

/// The check of RFC 1950. So many bytes are added up before a sum could overflow.
std::uint32_t adler32(std::string_view bytes) {
  constexpr std::uint32_t base = 65521;
  constexpr std::size_t most = 5552;
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, most);
    for (const char byte : part) {
      a += static_cast<unsigned char>(byte);
      b += a;
    }
    a %= base;
    b %= base;
    bytes.remove_prefix(part.size());
  }
  return b << 16U | a;
}

}  // namespace

std::string stored(std::string_view bytes) {
  std::string made("\x78\x01");
  made.reserve(bytes.size() + bytes.size() / longest_block * 5 + 16);
  const std::uint32_t check = adler32(bytes);
  do {
    const std::string_view block = bytes.substr(0, longest_block);
    bytes.remove_prefix(block.size());
    made.push_back(bytes.empty() ? '\1' : '\0');
    put_pair(static_cast<std::uint32_t>(block.size()), made);
    put_pair(~static_cast<std::uint32_t>(block.size()), made);
    made += block;
  } while (!bytes.empty());
  for (unsigned shift = 32; shift > 0; shift -= 8) made.push_back(static_cast<char>(check >> (shift - 8) & 0xFFU));
  return made;
}

}  // namespace csgsim::web

namespace csgsim::report {

std::string deflated(std::string_view bytes) { return web::stored(bytes); }

}  // namespace csgsim::report
