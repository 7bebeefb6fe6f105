#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/field_role.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// Bits that working out a classification takes, besides the mask.
struct ClassificationBits {
  unsigned stack = 0;    ///< pending results
  unsigned product = 0;  ///< the product being worked out: 0 or 1
  unsigned label = 0;    ///< of the leaf that a pixel waits for
  unsigned stored = 0;   ///< depths of primitives that others are compared with, a front and a back each

  [[nodiscard]] unsigned total() const { return stack + product + label + stored; }
};

/// Of each the more.
ClassificationBits most_of(const ClassificationBits& a, const ClassificationBits& b);

/// Bits of pixel memory that somebody asks for.
struct FieldRequest {
  std::string name;
  isa::FieldRole role = isa::FieldRole::scratch;
  unsigned width = 0;          ///< 0: nothing is asked for
  std::string_view what;       ///< it holds, for people
  std::string_view without{};  ///< what to do where there is no room for it; may be empty
  bool is_scratch = false;     ///< holds nothing while surfaces are drawn, so that it may lie where Z1 lies then
};

/// What an effect asks for; its scratch may lie where another effect's does.
struct EffectFields {
  std::string_view effect;
  std::vector<FieldRequest> requests;
};

/// Bits that the depths of quadrics are worked out in.
struct QuadricBits {
  unsigned root = 0;     ///< of the square root
  unsigned squares = 0;  ///< of the squares that fast spheres need at each pixel (fast_spheres.h)
  unsigned sum = 0;      ///< of the depth before it is a depth, more than of the root; 0 where there is no quadric
  bool root_in_candidate = false;  ///< no depth but Z1 is worked out: a root is taken where Z1 is, and the bits below
  bool in_place = false;  ///< needs no sum and no bit for E: light is worked out over Z1, and E is the mask then

  bool operator==(const QuadricBits&) const = default;
};

/// What has to fit.
struct Needs {
  unsigned z_bits = 0;
  unsigned colour_bits = 0;
  bool second_colour = false;  ///< beside Z1
  ClassificationBits classification;
  isa::Field shown{};  ///< the machine's second buffer, which ends where the memory does; of width 0 if it has none
  unsigned owner_bits = 0;  ///< of the number of the surface that Z2 is of; 0 where nobody asks whose it is
  std::vector<EffectFields> effects{};
  QuadricBits quadrics{};
};

/// Which bits of pixel memory hold what. Fields that are not needed have no width.
struct Layout {
  isa::Field depth;                ///< Z2: the nearest surface so far
  isa::Field candidate;            ///< Z1: the surface being classified
  isa::Field colour;               ///< of Z2
  isa::Field candidate_colour;     ///< of Z1
  isa::Field mask;                 ///< 1 where Z1 holds a surface that is still visible
  isa::Field product;              ///< 1 where Z1 is in the product so far
  isa::Field label;                ///< the leaf that a pixel waits for
  std::vector<isa::Field> stack;   ///< results of the classification, one bit each
  std::vector<isa::Field> stored;  ///< depths of primitives, of each the front and then the back
  isa::Field owner;                ///< number of the surface that Z2 is of, 0 for none
  isa::Field sum;      ///< a depth of a quadric, or the low part of its discriminant while the root is taken
  isa::Field root;     ///< of a quadric, right above the sum, with that the discriminant; it may be a part of Z1
  isa::Field light;    ///< where light on quadrics is worked out: the sum; or Z1, which Z2 is a copy of then
  isa::Field squares;  ///< of the pixel's place, throughout; see fast_spheres.h
  isa::Field kept;     ///< E, while some pixels of it are worked on
  isa::Field shown;    ///< the picture before, which no instruction meets
  std::vector<isa::NamedField> effects;  ///< as `EFFECT.NAME`

  /// A field that an effect asked for.
  [[nodiscard]] isa::Field of(std::string_view effect, std::string_view name) const;
};

unsigned total_bits(const Needs& needs);

/// Throws InputError that says how many bits are missing, and which options would make it fit, if the memory does not
/// hold them.
Layout plan_layout(const Needs& needs, std::uint32_t memory_bits);

std::vector<isa::NamedField> named_fields(const Layout& layout);

}  // namespace csgsim::emit
