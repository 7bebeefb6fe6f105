#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/effects/blend.h"
#include "host/effects/rows.h"
#include "host/effects/texels.h"
#include "host/emit/early_out.h"
#include "host/emit/facet_colour.h"
#include "host/emit/facet_geometry.h"
#include "host/model/shapes.h"
#include "hw/base/error.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

enum class Pattern : std::uint8_t { checker, stripes, table };

constexpr std::array<std::string_view, 3> patterns{"checker", "stripes", "table"};

/// The texture of the facets of some primitives.
struct Texture : scene::PrimitiveSelection {
  Pattern pattern = Pattern::checker;
  glm::dvec3 first{1};
  glm::dvec3 second{0};
  scene::ColourTable texels;  ///< one row per step along v; repeated in both directions
  double size = 1;
  double u0 = 0;
  double v0 = 0;

  [[nodiscard]] unsigned column_bits() const { return static_cast<unsigned>(std::bit_width(texels[0].size())) - 1; }
  [[nodiscard]] unsigned row_bits() const { return static_cast<unsigned>(std::bit_width(texels.size())) - 1; }
  [[nodiscard]] unsigned bits() const { return column_bits() + row_bits(); }
};

/// The last texture that applies to a primitive counts.
using Settings = std::vector<Texture>;

constexpr std::size_t max_texels = 8;  ///< maximum rows or columns of a table
constexpr double max_lines = 512;      ///< maximum number of lines between the texels of one facet in perspective
constexpr double min_size = 1e-9;      ///< model units

void visit_keys(Texture& texture, auto&& visit) {
  scene::visit_keys(texture, visit);
  visit(scene::choice_key("pattern", patterns, "the repeated pattern; stripes run along v"), texture.pattern);
  visit(scene::colour_key("first", "colour of the texel at u0, v0: red, green, blue"), texture.first);
  visit(scene::colour_key("second", "colour of the other texels"), texture.second);
  visit(scene::colour_table_key("texels", "colours of a table: rows along v of colours along u; 1, 2, 4 or 8 of each"),
        texture.texels);
  visit(scene::number_key("size", "model units", min_size, scene::coordinate_limit, "side of a texel"), texture.size);
  visit(scene::number_key("u0", "model units", -scene::coordinate_limit, scene::coordinate_limit,
                          "start of the texture along u; u and v are the model axes most nearly parallel to the facet"),
        texture.u0);
  visit(scene::number_key("v0", "model units", -scene::coordinate_limit, scene::coordinate_limit,
                          "start of the texture along v"),
        texture.v0);
}

void check_table(const scene::ColourTable& texels) {
  const auto is_side = [](std::size_t count) { return std::has_single_bit(count) && count <= max_texels; };
  if (texels.empty()) throw InputError("pattern = \"table\" needs colours; add texels = [[[r, g, b], ...], ...]");
  if (!is_side(texels.size()) || !is_side(texels[0].size())) {
    throw InputError(
        fmt::format("texels has {} rows of {} colours; make it 1, 2, 4 or 8 of each", texels.size(), texels[0].size()));
  }
}

/// Patterns of two colours are converted to tables.
void complete(Texture& texture) {
  scene::complete(texture);
  if (texture.pattern == Pattern::table) {
    check_table(texture.texels);
  } else if (!texture.texels.empty()) {
    throw InputError("texels need pattern = \"table\"; add it, or remove texels");
  } else if (texture.pattern == Pattern::checker) {
    texture.texels = {{texture.first, texture.second}, {texture.second, texture.first}};
  } else {
    texture.texels = {{texture.first, texture.second}};
  }
}

const Texture* find_texture(const Settings& settings, const model::Primitive& primitive) {
  const auto found = std::find_if(settings.rbegin(), settings.rend(),
                                  [&](const Texture& one) { return lighting::is_selected(one, primitive); });
  return found == settings.rend() ? nullptr : &*found;
}

/// Colours one textured facet. The number of a texel has its column in the low bits and its row in the bits above.
class Shader {
 public:
  Shader(const emit::Context& context, emit::Broadcast& out, const emit::Facet& facet, const Texture& texture,
         const view::PixelRect& pixels)
      : context_(context),
        out_(out),
        facet_(facet),
        texture_(texture),
        pixels_(pixels),
        in_facet_(context.layout.of("textures", "facet")),
        texel_(context.layout.of("textures", "texel")) {}

  void emit(isa::Field colour) {
    out_.plain(Opcode::enable_store, in_facet_);
    const std::size_t begin = out_.size();
    const TexelCoordinates at = texel_coordinates(context_, facet_, {texture_.size, {texture_.u0, texture_.v0}});
    const isa::Field column = part(0, texture_.column_bits());
    const isa::Field row = part(texture_.column_bits(), texture_.row_bits());
    if (context_.view.camera.projection == view::Projection::orthographic) {
      emit_periodic(at.u, column);
      emit_periodic(at.v, row);
    } else {
      check_lines((column.width > 0 ? count_lines(at.u) : 0) + (row.width > 0 ? count_lines(at.v) : 0));
      emit_lines(at.u, column);
      emit_lines(at.v, row);
    }
    emit_colours(colour);
    emit::emit_early_out(context_, out_, begin, out_.origin);
  }

 private:
  [[nodiscard]] isa::Field part(unsigned begin, unsigned width) const { return subfield(texel_, begin, width); }

  [[noreturn]] void fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}", model::location_text(context_.tree, facet_.primitive), what));
  }

  [[noreturn]] void fail_size() const {
    fail("the texels of this primitive's texture are too large or too small for the picture; change its size");
  }

  void check_lines(double count) const {
    if (count <= max_lines) return;
    fail(
        fmt::format("{:.0f} lines between texels cross a face of this primitive, and in perspective at most {:.0f} are "
                    "possible, with an instruction for each; make the texture's size {:.3g} or larger, or use an "
                    "orthographic view, where they are periodic",
                    count, max_lines, texture_.size * count / max_lines * 1.01));
  }

  /// Computes the bits of floor(coordinate): the bits of a linear expression above its fraction.
  void emit_periodic(const TexelCoordinate& coordinate, isa::Field number) {
    if (number.width == 0) return;
    const auto linear = periodic(coordinate, number.width, context_.view.sampling);
    if (!linear) fail_size();
    for (unsigned bit = 0; bit < number.width; ++bit) {
      out_.plain(Opcode::enable_load, in_facet_);
      out_.stripe(linear->linear, linear->fraction_bits + bit + 1);
      out_.plain(Opcode::enable_store, subfield(number, bit, 1));
    }
  }

  /// Counts in pixel memory: each line flips the bits that change in counting, at the pixels beyond it.
  void emit_lines(const TexelCoordinate& coordinate, isa::Field number) {
    if (number.width == 0) return;
    const std::uint64_t all = (1U << number.width) - 1;
    const auto lines = texel_lines(coordinate, context_.view.sampling);
    if (!lines) fail_size();
    std::uint64_t start = static_cast<std::uint64_t>(lines->first) & all;
    std::vector<TexelLine> crossing;
    for (const TexelLine& line : lines->lines) {
      const bool is_beyond = line.line ? view::range_over(*line.line, pixels_).low >= 0 : line.is_beyond;
      if (is_beyond) start ^= changed(line) & all;
      if (!is_beyond && line.line && view::range_over(*line.line, pixels_).high >= 0) crossing.push_back(line);
    }
    out_.plain(Opcode::enable_load, in_facet_);
    out_.plain(Opcode::set_constant, number, {}, start);
    for (const TexelLine& line : crossing) {
      out_.plain(Opcode::enable_load, in_facet_);
      out_.edge(Opcode::edge_not_negative, *line.line, pixels_);
      const std::uint64_t bits = changed(line) & all;
      out_.plain(Opcode::xor_constant, subfield(number, 0, static_cast<unsigned>(std::bit_width(bits))), {}, bits);
    }
  }

  /// Bits in which the numbers of the texels on the two sides of the line differ.
  static std::uint64_t changed(const TexelLine& line) {
    return static_cast<std::uint64_t>(line.number) ^ static_cast<std::uint64_t>(line.number - 1);
  }

  /// Writes the most frequent colour everywhere, then the other colours texel by texel.
  void emit_colours(isa::Field field) {
    std::vector<std::uint32_t> colours;
    std::map<std::uint32_t, std::size_t> counts;
    for (const auto& row : texture_.texels)
      for (const glm::dvec3& texel : row) {
        colours.push_back(emit::facet_colour(context_, facet_, texel));
        ++counts[colours.back()];
      }
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& one, const auto& other) { return one.second < other.second; });
    out_.plain(Opcode::enable_load, in_facet_);
    out_.plain(Opcode::set_constant, field, {}, most->first);
    for (std::size_t texel = 0; texel < colours.size(); ++texel) {
      if (colours[texel] == most->first) continue;
      out_.plain(Opcode::enable_load, in_facet_);
      for (unsigned bit = 0; bit < texture_.bits(); ++bit) {
        out_.plain(((texel >> bit) & 1U) != 0 ? Opcode::enable_and : Opcode::enable_and_not, part(bit, 1));
      }
      out_.plain(Opcode::set_constant, field, {}, colours[texel]);
    }
  }

  const emit::Context& context_;
  emit::Broadcast& out_;
  const emit::Facet& facet_;
  const Texture& texture_;
  const view::PixelRect& pixels_;
  isa::Field in_facet_;
  isa::Field texel_;
};

class Textures final : public emit::EffectOf<Settings> {
 public:
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& /*drawing*/,
                                                       const emit::DrawingInputs& /*inputs*/) const override {
    unsigned bits = 0;
    for (const Texture& one : settings) bits = std::max(bits, one.bits());
    return {{"facet", isa::FieldRole::effect, 1, "pixels of a textured facet"},
            {"texel", isa::FieldRole::effect, bits, "number of a texel"}};
  }

  bool shade(const emit::EffectCall& call, emit::Broadcast& out, const emit::Facet& facet, isa::Field field,
             const view::PixelRect& pixels) const override {
    const emit::Context& context = call.context;
    const model::Primitive& primitive = context.tree.primitives[facet.primitive];
    if (facet.at != emit::At::plane || !emit::is_flat(primitive, emit::outward_normal(context, facet))) return false;
    const Texture* const texture = find_texture(settings, primitive);
    if (texture == nullptr) return false;
    Shader(context, out, facet, *texture, pixels).emit(field);
    return true;
  }

 private:
  void prepare(State& /*state*/, const emit::Drawing& drawing, const emit::DrawingInputs& /*inputs*/) const override {
    const std::vector<model::Primitive>& primitives = drawing.tree->primitives;
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
      const Texture* const texture = find_texture(settings, primitives[i]);
      const bool is_named = texture != nullptr && (texture->of_colour || texture->from_line);
      if (!is_named || model::has_flat_faces(primitives[i].shape)) continue;
      throw InputError(
          fmt::format("{}: textures are only for flat facets, and this is a {}; name cubes, polyhedra or cylinders, "
                      "whose ends are flat, in [[effects.textures]]",
                      model::location_text(*drawing.tree, i), model::name_of(primitives[i].shape)));
    }
  }
};

}  // namespace

extern const emit::EffectRow textures{
    .section = scene::effect_section<Settings>("effects.textures",
                                               "patterns on flat facets; each table applies to some primitives"),
    .technique =
        "Fuchs et al. 1985: textures are painted by comparing linear expressions at every pixel; here an "
        "orthographic pattern is bits of one such expression, and in perspective each boundary is a line",
    .parts = emit::parts_of<Textures>};

}  // namespace csgsim::effects
