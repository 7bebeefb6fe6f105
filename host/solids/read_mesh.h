// Readers of mesh files: STL, OFF, OBJ, PLY, AMF and 3MF.
// Used throughout host/solids and by host/read and sim/web.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

inline constexpr std::size_t max_mesh_bytes = std::size_t{1} << 30U;  ///< maximum size of a mesh file
inline constexpr std::size_t max_mesh_faces = 4'000'000;

/// The extension of a file name in lower case, such as `.stl`.
std::string lower_case_extension(const std::filesystem::path& path);

/// Parses the meshes of a file whose format follows from its extension: .stl, .off, .obj, .ply, .amf or .3mf. An STL,
/// OFF, OBJ or PLY file has one mesh. Points may repeat; only finite coordinates and valid corner indices are checked.
/// `text` is the content of the file; its name appears in messages. Throws InputError with the file name and, where
/// known, the position in it.
std::vector<Mesh> parse_meshes(std::string_view text, const std::filesystem::path& path);

/// Parses STL, binary or text. Normals are ignored, as in OpenSCAD. Text files may contain triangles only.
Mesh parse_stl(std::string_view text, std::string_view name);

/// Parses the text form of the Object File Format. Colours and normals after a point's coordinates or a face's corners
/// are ignored.
Mesh parse_off(std::string_view text, std::string_view name);

/// Parses Wavefront OBJ with all its objects. Materials and other attributes of appearance are ignored; curves and
/// surfaces are rejected.
Mesh parse_obj(std::string_view text, std::string_view name);

/// Parses the Polygon File Format (PLY), as text or binary in either byte order: the points of its element `vertex` and
/// the faces of its element `face`. Other elements and properties are ignored.
Mesh parse_ply(std::string_view text, std::string_view name);

/// Parses an Additive Manufacturing File, which may be zipped: one mesh per object, with all its volumes. As in
/// OpenSCAD, curved triangles are treated as flat; units and constellations are ignored.
std::vector<Mesh> parse_amf(std::string_view text, std::string_view name);

/// Parses the 3D Manufacturing Format: one mesh per object that has a mesh. As in OpenSCAD, units, components and build
/// transforms are ignored.
std::vector<Mesh> parse_3mf(std::string_view text, std::string_view name);

}  // namespace csgsim::solids
