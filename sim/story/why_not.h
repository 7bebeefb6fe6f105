// Explains why a primitive is not visible at a pixel.
// Used by answer.cpp, story_json.h and story_text.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/pieces.h"
#include "sim/story/phrases.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// The reason why a primitive is not visible at a pixel.
struct WhyNot {
  isa::PieceRange pieces;
  /// The primitive in whose place the first piece is drawn: the piece itself or, if several primitives are drawn as one
  /// convex solid, the first of these.
  std::uint32_t drawn_as = 0;
  bool is_seen = false;               ///< one of the pieces is visible at the pixel
  bool is_broadcast = false;          ///< some instruction of the segment draws a surface of the pieces
  std::vector<std::size_t> attempts;  ///< indices into Story::attempts
};

/// Determines why the primitive is not visible at the pixel of the story.
WhyNot why_not(const Subject& subject, const Story& story, std::uint32_t primitive);

/// One sentence on how an attempt ended.
std::string fate_text(const Subject& subject, const Story& story, const Attempt& attempt);

/// The answer as text, in lines.
std::string text_of(const Subject& subject, const Story& story, const WhyNot& answer);

}  // namespace csgsim::story
