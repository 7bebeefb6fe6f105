// Functions that need other programs, or libraries not compiled for the web. They fail with advice.
#include <fmt/format.h>

#include "host/flat/svg.h"
#include "host/solids/height_picture.h"
#include "host/solids/read_mesh.h"
#include "hw/base/error.h"
#include "hw/base/module.h"
#include "sim/session/model/scad.h"
#include "sim/viewer/recorded.h"

namespace csgsim {

const void* load_module_symbol(const ModuleRole& role) {
  throw InputError(fmt::format(
      "this page does not include the part of csgsim that {}; use csgsim view on your computer", role.does));
}

namespace {

[[noreturn]] void refuse_format(std::string_view name) {
  throw InputError(fmt::format(
      "{}: this page cannot read files of this format; open the model with csgsim view on your computer", name));
}

}  // namespace

flat::Area flat::read_svg(std::string_view /*bytes*/, const SvgOptions& /*options*/) { refuse_format("SVG"); }

namespace solids {

Pixels read_png(std::string_view /*bytes*/, std::string_view name, std::size_t /*most*/) { refuse_format(name); }

std::vector<Mesh> parse_amf(std::string_view /*bytes*/, std::string_view name) { refuse_format(name); }

std::vector<Mesh> parse_3mf(std::string_view /*bytes*/, std::string_view name) { refuse_format(name); }

}  // namespace solids

namespace session {

std::string evaluate_scad(const std::string& file, const std::optional<std::string>& /*replacement*/,
                          const ScadOptions& /*options*/) {
  throw InputError(
      file +
      ": this page does not include OpenSCAD; export the model as .csg there (File, Export), and open that file");
}

}  // namespace session

namespace viewer {

std::string record_wave(const isa::Program& /*program*/, std::span<const std::string> /*options*/) {
  throw InputError("this page cannot record waveforms or lanes; use csgsim view on your computer");
}

}  // namespace viewer

}  // namespace csgsim
