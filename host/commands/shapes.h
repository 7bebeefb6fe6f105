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

/// A curve of a file, with how many numbers each of its points has.
struct Curve {
  swept::Curve curve;
  std::size_t numbers = 0;
  std::uint32_t offset = 0;
};

/// The words that a primitive solid begins with.
bool is_solid_word(std::string_view word);

/// The one of them that a word is nearly; empty if it is like none.
std::string_view solid_word_like(std::string_view word);

/// After its word: a primitive, of which round ones are faceted like this.
model::Shape read_solid(std::string_view word, Cursor& line, const model::FacetControl& facets);

/// After `curve`.
Curve read_curve(Cursor& line);

/// After `patch`; a tolerance, which may end it, is left.
swept::Net read_net(Cursor& line);

}  // namespace csgsim::commands
