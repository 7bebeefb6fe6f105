// How curved primitives are drawn: as facets, fast spheres or quadrics.
// Used by host/setup, sim/session and sim/studies.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/emit/look.h"
#include "host/emit/options.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// How spheres, cylinders and cones are drawn.
enum class Curves : std::uint8_t {
  facets,     ///< as polyhedra
  fast,       ///< spheres as fast spheres (host/view/fast_sphere.h), on any machine; other shapes as polyhedra
  exact,      ///< as quadrics
  automatic,  ///< as quadrics if the machine and the scene's effects support it, else as polyhedra
};

inline constexpr std::array curve_choices{Curves::facets, Curves::fast, Curves::exact, Curves::automatic};

/// The choice's name on the command line and in the stats.
std::string_view name_of(Curves curves);

/// Error text: the reason why the machine or the scene's effects do not support quadrics, and what to do. Empty if they
/// do.
std::optional<std::string> quadrics_unsupported_reason(const machines::Machine& machine, const Options& options,
                                                       const Look& look);

/// Error text: the reason why only facets can be drawn, even on a machine that evaluates quadrics, and what to do.
/// Empty if curves can be drawn.
std::optional<std::string> curves_unsupported_reason(const machines::Machine& machine, const Options& options,
                                                     const Look& look);

}  // namespace csgsim::emit
