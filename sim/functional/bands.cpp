#include "sim/functional/bands.h"

#include <algorithm>
#include <functional>
#include <thread>

namespace csgsim::sim {

namespace {

Bands::Tally run_band(Array& array, std::span<const isa::Instruction> instructions) {
  Bands::Tally tally;
  tally.enabled.reserve(instructions.size());
  for (const isa::Instruction& instruction : instructions) {
    tally.enabled.push_back(array.enabled());
    tally.overflows += array.execute(instruction);
  }
  return tally;
}

}  // namespace

void Bands::begin(const isa::Region& region) {
  const bool fits = !arrays_.empty() && region_.width == region.width && region_.height == region.height;
  region_ = region;
  if (fits) {
    for (Array& array : arrays_) array.clear();
    return;
  }
  arrays_.clear();
  const std::uint32_t bands = std::min(count_, region.height);
  for (std::uint32_t band = 0; band < bands; ++band) {
    const std::uint32_t first = region.height * band / bands;
    const std::uint32_t end = region.height * (band + 1) / bands;
    arrays_.emplace_back(region.width, first, end - first, program_.shape.memory_bits);
  }
}

Bands::Tally Bands::execute(std::span<const isa::Instruction> instructions) {
  std::vector<Tally> tallies(arrays_.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t band = 1; band < arrays_.size(); ++band) {
      threads.emplace_back([&, band] { tallies[band] = run_band(arrays_[band], instructions); });
    }
    tallies.front() = run_band(arrays_.front(), instructions);
  }
  Tally all = std::move(tallies.front());
  for (std::size_t band = 1; band < tallies.size(); ++band) {
    all.overflows += tallies[band].overflows;
    std::transform(all.enabled.begin(), all.enabled.end(), tallies[band].enabled.begin(), all.enabled.begin(),
                   std::plus<>());
  }
  return all;
}

void Bands::read_field(isa::Field field, std::span<std::uint32_t> values) const {
  for (const Array& array : arrays_) {
    array.read_field(field, values.subspan(std::size_t{array.first_row()} * array.width(),
                                           std::size_t{array.rows()} * array.width()));
  }
}

void Bands::read_enable(std::span<std::uint64_t> words) const {
  const std::size_t words_per_row = (region_.width + 63) / 64;
  for (const Array& array : arrays_) {
    array.read_enable(words.subspan(array.first_row() * words_per_row, array.rows() * words_per_row));
  }
}

}  // namespace csgsim::sim
