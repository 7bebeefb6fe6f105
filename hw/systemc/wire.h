// Concept for values on SystemC wires.
// Used by hw/pixel_planes, hw/scan_line and hw/multi_processor.
#pragma once

#include <concepts>

namespace csgsim::systemc {

/// Whether a type is one of the given types; constrains templates of operators. SystemC requires `operator<<` and
/// `sc_trace` for values on wires and in FIFOs, in their namespace, but they are never called: waves use taps
/// (hw/wave).
template <class Value, class... Values>
concept OneOf = (std::same_as<Value, Values> || ...);

}  // namespace csgsim::systemc
