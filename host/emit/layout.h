// The layout of pixel memory: which bits hold what.
// Used by the emitter and the effects.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/field_role.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// Bits for computing a classification, in addition to the mask.
struct ClassificationBits {
  unsigned stack = 0;    ///< pending results
  unsigned product = 0;  ///< the product being computed: 0 or 1
  unsigned label = 0;    ///< label of the leaf that a pixel waits for
  unsigned stored = 0;   ///< depths of the primitives that others are compared with, a front and a back each

  [[nodiscard]] unsigned total() const { return stack + product + label + stored; }
};

/// The greater of each count.
ClassificationBits max_bits(const ClassificationBits& a, const ClassificationBits& b);

/// A request for bits of pixel memory.
struct FieldRequest {
  std::string name;
  isa::FieldRole role = isa::FieldRole::scratch;
  unsigned width = 0;          ///< 0: no field
  std::string_view what;       ///< purpose, for messages
  std::string_view without{};  ///< advice if there is no room for the field; may be empty
  bool is_scratch = false;     ///< unused while surfaces are drawn, so that it may overlap Z1
};

/// The requests of an effect. Scratch fields of different effects may overlap.
struct EffectFields {
  std::string_view effect;
  std::vector<FieldRequest> requests;
};

/// Bits for computing the depths of quadrics.
struct QuadricBits {
  unsigned root = 0;               ///< bits of the square root
  unsigned squares = 0;            ///< bits of the squares that fast spheres need at each pixel (fast_spheres.h)
  unsigned sum = 0;                ///< bits of a depth before clamping, beyond those of the root; 0 without quadrics
  bool root_in_candidate = false;  ///< Z1 is the only depth computed: the root is computed in Z1 and the bits below
  bool in_place = false;  ///< needs neither a sum nor a bit for E: light is computed in Z1, and E equals the mask then

  bool operator==(const QuadricBits&) const = default;
};

/// The requirements that have to fit into pixel memory.
struct Needs {
  unsigned z_bits = 0;
  unsigned colour_bits = 0;
  bool second_colour = false;  ///< a colour field for Z1
  ClassificationBits classification;
  isa::Field shown{};       ///< the machine's second buffer, which ends at the end of memory; width 0 if there is none
  unsigned owner_bits = 0;  ///< bits of the number of the surface in Z2; 0 if no owners are kept
  std::vector<EffectFields> effects{};
  QuadricBits quadrics{};
};

/// The positions of all fields in pixel memory. Unused fields have width 0.
struct Layout {
  isa::Field depth;                ///< Z2: the nearest surface drawn until now
  isa::Field candidate;            ///< Z1: the surface being classified
  isa::Field colour;               ///< colour of Z2
  isa::Field candidate_colour;     ///< colour of Z1
  isa::Field mask;                 ///< 1 where Z1 holds a surface that is still visible
  isa::Field product;              ///< 1 where Z1 is in all leaves of the product compared until now
  isa::Field label;                ///< label of the leaf that a pixel waits for
  std::vector<isa::Field> stack;   ///< results of the classification, one bit each
  std::vector<isa::Field> stored;  ///< depths of primitives, for each the front and then the back
  isa::Field owner;                ///< number of the surface in Z2, 0 for none
  isa::Field sum;      ///< a depth of a quadric, or the low part of its discriminant while the root is taken
  isa::Field root;     ///< root of a quadric, directly above the sum, which holds the rest of the discriminant; may be
                       ///< a part of Z1
  isa::Field light;    ///< scratch for light on quadrics: the sum, or Z1 after it was copied to Z2
  isa::Field squares;  ///< squares of the pixel's position, constant throughout; see fast_spheres.h
  isa::Field kept;     ///< saved E, while a subset of its pixels is enabled
  isa::Field shown;    ///< the picture being displayed, which no instruction accesses
  std::vector<isa::NamedField> effects;  ///< as `EFFECT.NAME`

  /// The field that an effect requested.
  [[nodiscard]] isa::Field of(std::string_view effect, std::string_view name) const;
};

unsigned total_bits(const Needs& needs);

/// Throws InputError with the number of missing bits, and the options that would make it fit, if the memory is too
/// small.
Layout plan_layout(const Needs& needs, std::uint32_t memory_bits);

std::vector<isa::NamedField> named_fields(const Layout& layout);

}  // namespace csgsim::emit
