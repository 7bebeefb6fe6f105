#pragma once

#include <concepts>

namespace csgsim::systemc {

/// Of values on wires and in FIFOs. SystemC asks for `operator<<` and `sc_trace` of each, in its namespace, though
/// nobody prints or traces one: waves show taps (hw/wave).
template <class Value, class... Values>
concept OneOf = (std::same_as<Value, Values> || ...);

}  // namespace csgsim::systemc
