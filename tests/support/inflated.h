#pragma once

#include <zlib.h>

#include "tests/support/test.h"

namespace csgsim::testing {

/// What zlib makes of packed bytes that are to become `length` ones. There is room for one more.
inline std::string inflated(const std::string& packed, std::size_t length) {
  std::string bytes(length + 1, '?');
  uLongf size = bytes.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                     packed.size()) == Z_OK);
  bytes.resize(size);
  return bytes;
}

}  // namespace csgsim::testing
