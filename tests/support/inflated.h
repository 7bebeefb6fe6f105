#pragma once

#include <zlib.h>

#include "tests/support/test.h"

namespace csgsim::testing {

/// Decompresses with zlib to an expected `length` bytes. The buffer has one extra byte so that a longer result is
/// noticed.
inline std::string inflated(const std::string& packed, std::size_t length) {
  std::string bytes(length + 1, '?');
  uLongf size = bytes.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                     packed.size()) == Z_OK);
  bytes.resize(size);
  return bytes;
}

}  // namespace csgsim::testing
