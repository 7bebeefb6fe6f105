// Solids, curves and patches of a line of commands.
// Used by the interpreter.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "host/commands/cursor.h"
#include "host/model/tree.h"
#include "host/swept/curve.h"
#include "host/swept/net.h"

namespace csgsim::commands {

/// A curve defined in a file.
struct Curve {
  swept::Curve curve;
  std::size_t numbers = 0;   ///< count of numbers in each of its points
  std::uint32_t offset = 0;  ///< position in the text
};

/// Whether a word names a primitive solid.
bool is_solid_word(std::string_view word);

/// The name of a primitive solid that is similar to the word; empty if there is none.
std::string_view similar_solid_word(std::string_view word);

/// Reads a primitive solid after its word. `facets` determines the facets of round solids.
model::Shape read_solid(std::string_view word, Cursor& line, const model::FacetControl& facets);

/// Reads a curve after the word `curve`.
Curve read_curve(Cursor& line);

/// Reads a patch after the word `patch`. Stops before the tolerance, which is optional.
swept::Net read_net(Cursor& line);

}  // namespace csgsim::commands
