// Variants of a design: its figures at other values of their ranges.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/sensitivity/figures.h"

namespace csgsim::studies {

/// A figure, given by its index, and a value that differs from the stated one.
struct Setting {
  std::size_t figure = 0;
  std::int64_t value = 0;

  bool operator==(const Setting&) const = default;
};

/// The figures that differ from the stated ones, in the order of the figures.
using Variant = std::vector<Setting>;

/// The variants that every design has, and what each stands for.
struct Variants {
  std::vector<RangedFigure> figures;
  std::vector<Variant> all;            ///< all different; the first has the stated figures
  std::vector<std::size_t> low{};      ///< index of the variant with each figure at its low value
  std::vector<std::size_t> high{};     ///< index of the variant with each figure at its high value
  std::vector<std::size_t> samples{};  ///< index of the variant of each sample
};

/// Settings of the samples.
struct SampleChoice {
  std::uint32_t samples = 0;
  std::uint32_t seed = 1;
};

Variants make_variants(std::vector<RangedFigure> figures, const SampleChoice& choice);

/// `+KEY=VALUE` for each setting of the machine, or of the process.
std::string name_suffix(const Variants& variants, const Variant& variant, bool is_of_process);

/// Text such as `gate.delay=2000, link.width=16`.
std::string variant_text(const Variants& variants, const Variant& variant);

}  // namespace csgsim::studies
