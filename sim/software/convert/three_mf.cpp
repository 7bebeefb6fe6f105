#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <cstdio>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// An in-memory file for minizip.
struct MemoryStream {
  std::string bytes;
  std::size_t at = 0;
};

voidpf open_stream(voidpf opaque, const void*, int) { return opaque; }

uLong read_stream(voidpf, voidpf, void*, uLong) { return 0; }

uLong write_stream(voidpf, voidpf stream, const void* bytes, uLong count) {
  MemoryStream& to = *static_cast<MemoryStream*>(stream);
  to.bytes.resize(std::max(to.bytes.size(), to.at + count));
  std::copy_n(static_cast<const char*>(bytes), count, to.bytes.begin() + static_cast<std::ptrdiff_t>(to.at));
  to.at += count;
  return count;
}

ZPOS64_T tell_stream(voidpf, voidpf stream) { return static_cast<MemoryStream*>(stream)->at; }

long seek_stream(voidpf, voidpf stream, ZPOS64_T offset, int origin) {
  MemoryStream& in = *static_cast<MemoryStream*>(stream);
  in.at = (origin == SEEK_SET ? 0 : origin == SEEK_CUR ? in.at : in.bytes.size()) + offset;
  return 0;
}

int close_stream(voidpf, voidpf) { return 0; }

/// A reproducible zip archive: equal content gives equal bytes.
class Archive {
 public:
  Archive() {
    zlib_filefunc64_def functions{open_stream, read_stream,  write_stream, tell_stream,
                                  seek_stream, close_stream, close_stream, &stream_};
    file_ = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
    check(file_ == nullptr ? ZIP_INTERNALERROR : ZIP_OK);
  }
  ~Archive() {
    if (file_ != nullptr) zipClose(file_, nullptr);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  void add(const char* name, std::string_view part) {
    constexpr uLong first_of_1980 = 0x00210000;
    zip_fileinfo info{};
    info.dosDate = first_of_1980;
    check(zipOpenNewFileInZip64(file_, name, &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, Z_DEFAULT_COMPRESSION,
                                0));
    check(zipWriteInFileInZip(file_, part.data(), static_cast<unsigned>(part.size())));
    check(zipCloseFileInZip(file_));
  }

  std::string finish() {
    check(zipClose(std::exchange(file_, nullptr), nullptr));
    return std::move(stream_.bytes);
  }

 private:
  static void check(int result) {
    if (result != ZIP_OK) throw InputError("the mesh cannot be compressed; there may not be enough memory");
  }

  MemoryStream stream_;
  zipFile file_ = nullptr;
};

constexpr std::string_view content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";

constexpr std::string_view relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

struct TextWriter : pugi::xml_writer {
  std::string text;
  void write(const void* bytes, std::size_t count) override { text.append(static_cast<const char*>(bytes), count); }
};

void add_mesh(pugi::xml_node mesh, const Surface& surface) {
  const auto set = [](pugi::xml_node& node, const char* name, const auto& value) {
    node.append_attribute(name).set_value(fmt::format("{}", value).c_str());
  };
  pugi::xml_node vertices = mesh.append_child("vertices");
  for (const glm::dvec3& point : surface.points) {
    pugi::xml_node vertex = vertices.append_child("vertex");
    set(vertex, "x", point.x);
    set(vertex, "y", point.y);
    set(vertex, "z", point.z);
  }
  pugi::xml_node triangles = mesh.append_child("triangles");
  for (const Triangle& corners : surface.triangles) {
    pugi::xml_node triangle = triangles.append_child("triangle");
    set(triangle, "v1", corners[0]);
    set(triangle, "v2", corners[1]);
    set(triangle, "v3", corners[2]);
  }
}

/// One object and one build item. 3MF files without a unit are in millimetres, as are OpenSCAD models.
std::string model_part(const Surface& surface) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node model = document.append_child("model");
  model.append_attribute("unit") = "millimeter";
  model.append_attribute("xmlns") = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
  pugi::xml_node object = model.append_child("resources").append_child("object");
  object.append_attribute("id") = 1;
  object.append_attribute("type") = "model";
  add_mesh(object.append_child("mesh"), surface);
  model.append_child("build").append_child("item").append_attribute("objectid") = 1;
  TextWriter writer;
  document.save(writer, " ");
  return std::move(writer.text);
}

std::string write(const Surface& surface, const WriteOptions&) {
  const std::string model = model_part(surface);
  constexpr std::size_t max_bytes = 0xffffffffU;
  if (model.size() >= max_bytes) throw InputError("the 3MF file would exceed 4 GiB; make the facets coarser");
  Archive archive;
  archive.add("[Content_Types].xml", content_types);
  archive.add("_rels/.rels", relationships);
  archive.add("3D/3dmodel.model", model);
  return archive.finish();
}

}  // namespace

extern const Format three_mf_format{.ending = ".3mf",
                                    .help = "3D Manufacturing Format, triangles of double precision with shared points",
                                    .is_binary = true,
                                    .write = write};

}  // namespace csgsim::software::convert
