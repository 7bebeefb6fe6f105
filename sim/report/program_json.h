#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "hw/isa/program.h"
#include "sim/story/halfspaces.h"

namespace csgsim::report {

/// A Program as memory.js reads it: `width`, `height`, `memoryBits`; `colour` and `background`; `fields`, each with the
/// `token` that instructions name it by; names of `primitives` and how many `pieces` each has; `effects`; the `depth`
/// scale; with a model, `places` of pieces, each with the `front` of those drawn as one with it and its `pixels`;
/// operands of `opcodes`; `segments` as [x, y, width, height, number of instructions]; `instructions`, a line each: its
/// text, whom it serves, and, if it streams a half-space's plane or a quadric's outline, which of `geometry` that is,
/// counted from the one after the last that was named, with tabulators between; `geometry`, texts of these, none
/// without a model; and `skips`, numbers of the questions that skipped what follows them.
nlohmann::ordered_json program_json(const isa::Program& program, std::span<const std::uint64_t> skips,
                                    const story::HalfspaceFinder* model);

}  // namespace csgsim::report
