#include <fmt/format.h>

#include <iterator>

#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// One object, in millimetres.
std::string write(const Surface& surface, const WriteOptions&) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf unit=\"millimeter\">\n <object id=\"0\">\n  <mesh>\n"
      "   <vertices>\n";
  const auto out = std::back_inserter(text);
  for (const glm::dvec3& point : surface.points) {
    fmt::format_to(out, "    <vertex><coordinates><x>{}</x><y>{}</y><z>{}</z></coordinates></vertex>\n", point.x,
                   point.y, point.z);
  }
  text += "   </vertices>\n   <volume>\n";
  for (const Triangle& corners : surface.triangles) {
    fmt::format_to(out, "    <triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>\n", corners[0], corners[1],
                   corners[2]);
  }
  return text + "   </volume>\n  </mesh>\n </object>\n</amf>\n";
}

}  // namespace

extern const Format amf_format{.ending = ".amf",
                               .help = "Additive Manufacturing File, triangles of double precision with shared points",
                               .write = write};

}  // namespace csgsim::software::convert
