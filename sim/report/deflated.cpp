#include <zlib.h>

#include <new>

#include "sim/report/codec.h"

namespace csgsim::report {

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  const auto* const from = reinterpret_cast<const Bytef*>(bytes.data());
  auto* const to = reinterpret_cast<Bytef*>(packed.data());
  if (compress2(to, &size, from, static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK) throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace csgsim::report
