// Mesh files: STL, OFF, OBJ, PLY, AMF and 3MF. Every reader gets every input; an XML document is also wrapped as the
// model of a 3MF package, because mutations could not keep the package's checksum valid.

#include <zlib.h>

#include <string>
#include <vector>

#include "host/solids/limits.h"
#include "host/solids/read_mesh.h"
#include "tests/fuzz/mesh_invariants.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace solids = csgsim::solids;

namespace {

void append(std::string& bytes, std::initializer_list<std::uint32_t> numbers, std::size_t size) {
  for (const std::uint32_t number : numbers) {
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(number >> 8U * i);
  }
}

/// A zip archive of uncompressed parts (APPNOTE.TXT, the ZIP file format specification).
class Archive {
 public:
  void add(const std::string& name, std::string_view part) {
    const auto at = static_cast<std::uint32_t>(bytes_.size());
    const auto size = static_cast<std::uint32_t>(part.size());
    const auto crc = static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(part.data()), part.size()));
    std::string common;  // fields shared by a part's header and its directory entry
    append(common, {20, 0, 0, 0, 0}, 2);
    append(common, {crc, size, size}, 4);
    append(common, {static_cast<std::uint32_t>(name.size()), 0}, 2);
    bytes_.append("PK\x03\x04").append(common).append(name).append(part);
    directory_ += "PK\x01\x02";
    append(directory_, {20}, 2);
    directory_ += common;
    append(directory_, {0, 0, 0}, 2);
    append(directory_, {0, at}, 4);
    directory_ += name;
    ++parts_;
  }

  [[nodiscard]] std::string bytes() const {
    std::string end = "PK\x05\x06";
    append(end, {0, 0, parts_, parts_}, 2);
    append(end, {static_cast<std::uint32_t>(directory_.size()), static_cast<std::uint32_t>(bytes_.size())}, 4);
    append(end, {0}, 2);
    return bytes_ + directory_ + end;
  }

 private:
  std::string bytes_;
  std::string directory_;
  std::uint32_t parts_ = 0;
};

std::string package(std::string_view model) {
  Archive archive;
  archive.add("_rels/.rels", R"(<Relationships><Relationship Target="/m" Type="a/3dmodel"/></Relationships>)");
  archive.add("m", model);
  return archive.bytes();
}

template <class Read>
void check(Read read, double tolerance) {
  try {
    for (const solids::Mesh& mesh : read()) fuzz::check_mesh(mesh, tolerance);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
}

}  // namespace

/// Any bytes give valid meshes or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  check([&] { return std::vector{solids::parse_stl(text, "m")}; }, solids::single_precision_tolerance);
  check([&] { return std::vector{solids::parse_off(text, "m")}; }, solids::printed_tolerance);
  check([&] { return std::vector{solids::parse_obj(text, "m")}; }, solids::printed_tolerance);
  check([&] { return std::vector{solids::parse_ply(text, "m")}; }, solids::printed_tolerance);
  check([&] { return solids::parse_amf(text, "m"); }, solids::printed_tolerance);
  check([&] { return solids::parse_3mf(text, "m"); }, solids::single_precision_tolerance);
  if (text.starts_with('<')) {
    const std::string bytes = package(text);
    check([&] { return solids::parse_3mf(bytes, "m"); }, solids::single_precision_tolerance);
  }
  return 0;
}
