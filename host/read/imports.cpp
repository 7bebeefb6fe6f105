#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "host/flat/dxf.h"
#include "host/flat/svg.h"
#include "host/read/mesh_pieces.h"
#include "host/read/node_readers.h"
#include "host/read/shared_arguments.h"
#include "host/solids/read_mesh.h"
#include "host/solids/surface.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::read {

namespace {

namespace fs = std::filesystem;

constexpr InputKind mesh_or_drawing{"a mesh or a drawing", solids::max_mesh_bytes, "make it coarser"};

flat::Area svg_area(const Arguments& arguments, const std::string& bytes) {
  flat::SvgOptions options;
  options.dpi = arguments.number("dpi").value_or(options.dpi);
  options.center = arguments.boolean("center").value_or(options.center);
  options.work = arguments.work();
  return flat::read_svg(bytes, options);
}

}  // namespace

flat::Area dxf_area(const Arguments& arguments, std::string_view bytes, double scale) {
  flat::DxfOptions options;
  options.layer = arguments.text("layer").value_or("");
  if (const std::optional<ValueView> origin = arguments.find("origin")) {
    std::array<double, 2> both{};
    arguments.read_numbers(*origin, 2, both, "origin");
    options.origin = {both[0], both[1]};
  }
  options.scale = scale;
  options.work = arguments.work();
  options.facets = read_facets(arguments);
  return flat::read_dxf(bytes, options);
}

namespace {

NodeResult make_meshes(const Arguments& arguments, const ImportedFile& file, const std::string& kind) {
  const double tolerance =
      kind == ".stl" || kind == ".3mf" ? solids::single_precision_tolerance : solids::printed_tolerance;
  NodeResult made;
  made.dimensions = 3;
  for (const solids::Mesh& mesh : solids::parse_meshes(file.bytes, file.path)) {
    const MeshPieces found = pieces_of(mesh, tolerance, arguments.mesh_placement(), arguments.work());
    if (found.defect)
      throw InputError(file.path.string() + ": face " + std::to_string(found.defect->face) + ": " + found.defect->what);
    for (const Remark& remark : found.remarks)
      arguments.report(fmt::format("{}: {}", printable(file.path.native()), remark.what));
    made.pieces.insert(made.pieces.end(), found.pieces.begin(), found.pieces.end());
  }
  return made;
}

NodeResult make_import(const Arguments& arguments) {
  const std::optional<ImportedFile> file = arguments.file(mesh_or_drawing);
  const std::string kind =
      solids::lower_case_extension(file ? file->path : fs::path(arguments.text("file").value_or("")));
  const bool is_drawing = kind == ".svg" || kind == ".dxf";
  if (!file) return {{}, {}, {}, is_drawing ? 2U : 3U};
  try {
    if (kind == ".svg") return {{}, svg_area(arguments, file->bytes), {}, 2};
    if (kind == ".dxf") return {{}, dxf_area(arguments, file->bytes, arguments.number("scale").value_or(1)), {}, 2};
    return make_meshes(arguments, *file, kind);
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
}

}  // namespace

Maker read_surface(const Arguments& arguments) {
  const bool center = arguments.boolean("center").value_or(false);
  const bool invert = arguments.boolean("invert").value_or(false);
  const std::optional<ImportedFile> file = arguments.file(solids::surface_file);
  if (!file) return [](const Operands& /*none*/) { return NodeResult{{}, {}, {}, 3}; };
  MeshPieces found;
  try {
    found = pieces_of(solids::parse_surface_file(file->bytes, file->path, center, invert),
                      solids::double_precision_tolerance, arguments.mesh_placement(), arguments.work());
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
  if (found.defect) arguments.fail("{}", found.defect->what);
  return [pieces = std::move(found.pieces)](const Operands& /*none*/) { return NodeResult{pieces, {}, {}, 3}; };
}

Maker read_import(const Arguments& arguments) {
  return [made = make_import(arguments)](const Operands& /*none*/) { return made; };
}

}  // namespace csgsim::read
