#include "host/read/imports.h"

#include <filesystem>
#include <string>
#include <utility>

#include "host/flat/dxf.h"
#include "host/flat/svg.h"
#include "host/read/files.h"
#include "host/read/measures.h"
#include "host/read/mesh_pieces.h"
#include "host/solids/read_mesh.h"
#include "host/solids/surface.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

namespace fs = std::filesystem;

flat::Area svg_area(const Arguments& arguments, const std::string& bytes) {
  flat::SvgOptions options;
  options.dpi = arguments.number("dpi").value_or(options.dpi);
  options.center = arguments.boolean("center").value_or(options.center);
  return flat::read_svg(bytes, options).area;
}

}  // namespace

flat::Area dxf_area(const Arguments& arguments, const fs::path& path, double scale) {
  flat::DxfOptions options;
  options.layer = arguments.text("layer").value_or("");
  if (const std::optional<ValueView> origin = arguments.find("origin")) {
    std::array<double, 2> both{};
    arguments.read_numbers(*origin, 2, both, "origin");
    options.origin = {both[0], both[1]};
  }
  options.scale = scale;
  options.facets = read_facets(arguments);
  return flat::read_dxf(load(path.string()), options).area;
}

namespace {

Made mesh_made(const fs::path& path, const std::string& kind) {
  const double tolerance =
      kind == ".stl" || kind == ".3mf" ? solids::single_precision_tolerance : solids::printed_tolerance;
  Made made;
  for (const solids::Mesh& mesh : solids::read_meshes(path)) {
    const MeshPieces found = pieces_of(mesh, tolerance);
    if (found.defect)
      throw InputError(path.string() + ": face " + std::to_string(found.defect->face) + ": " + found.defect->what);
    made.pieces.insert(made.pieces.end(), found.pieces.begin(), found.pieces.end());
  }
  return made;
}

Made made_of(const Arguments& arguments) {
  if (!arguments.names_file()) return {};
  const fs::path path = file_of(arguments);
  const std::string kind = ending_of(path);
  try {
    if (kind == ".svg") return {{}, svg_area(arguments, load(path.string()))};
    if (kind == ".dxf") return {{}, dxf_area(arguments, path, arguments.number("scale").value_or(1))};
    return mesh_made(path, kind);
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
}

}  // namespace

Maker read_surface(const Arguments& arguments) {
  const bool center = arguments.boolean("center").value_or(false);
  const bool invert = arguments.boolean("invert").value_or(false);
  if (!arguments.names_file()) return [](const Operands& /*none*/) { return Made{}; };
  MeshPieces found;
  try {
    found = pieces_of(solids::read_surface(file_of(arguments), center, invert), solids::double_precision_tolerance);
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
  if (found.defect) arguments.fail("{}", found.defect->what);
  return [pieces = std::move(found.pieces)](const Operands& /*none*/) { return Made{pieces, {}}; };
}

Maker read_import(const Arguments& arguments) {
  return [made = made_of(arguments)](const Operands& /*none*/) { return made; };
}

}  // namespace csgsim::read
