#include "sim/software/draw.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "hw/base/hash.h"
#include "hw/base/seconds.h"

namespace csgsim::software {

namespace {

std::span<VisibleSurface> rows_of(Picture& picture, const RayBand& band) {
  return std::span(picture.seen).subspan(std::size_t{band.first_row} * band.width, band.rays());
}

Picture blank(const RayCaster& rays) {
  return {std::vector<VisibleSurface>(std::size_t{rays.width()} * rays.height())};
}

}  // namespace

Picture draw(const RayCaster& rays, Method& method, RayCounts* counts) {
  Picture picture = blank(rays);
  RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += band_rows) {
    rays.cast(row, band, counts);
    method.classify(band, rows_of(picture, band));
  }
  return picture;
}

Seconds measure_seconds(const RayCaster& rays, const std::function<std::unique_ptr<Method>()>& make) {
  constexpr unsigned max_runs = 5;
  constexpr double enough = 0.2;
  constexpr double never = std::numeric_limits<double>::infinity();
  Seconds min_seconds{never, never};
  Picture picture = blank(rays);
  RayBand band;
  double spent = 0;
  for (unsigned i = 0; i < max_runs && spent < enough; ++i) {
    Seconds seconds;
    const std::unique_ptr<Method> method = make();
    for (std::uint32_t row = 0; row < rays.height(); row += band_rows) {
      const auto begin = std::chrono::steady_clock::now();
      rays.cast(row, band);
      seconds.rays += seconds_since(begin);
      const auto cast = std::chrono::steady_clock::now();
      method->classify(band, rows_of(picture, band));
      seconds.classification += seconds_since(cast);
    }
    min_seconds = {std::min(min_seconds.rays, seconds.rays),
                   std::min(min_seconds.classification, seconds.classification)};
    spent += seconds.rays + seconds.classification;
  }
  return min_seconds;
}

std::string hash_of(const Picture& picture) {
  Hash hash;
  std::vector<std::uint32_t> values;
  values.reserve(picture.seen.size());
  for (const VisibleSurface& seen : picture.seen) values.push_back(seen.depth);
  hash.add(values);
  values.clear();
  for (const VisibleSurface& seen : picture.seen) values.push_back(seen.owner);
  hash.add(values);
  return hash.text();
}

Survey survey(const RayCaster& rays, const Picture& picture) {
  Surveyor surveyor;
  RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += band_rows) {
    rays.cast(row, band);
    surveyor.add(band, std::span(picture.seen).subspan(std::size_t{row} * band.width, band.rays()));
  }
  return surveyor.result();
}

}  // namespace csgsim::software
