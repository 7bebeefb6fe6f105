#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

inline constexpr std::size_t most_mesh_bytes = std::size_t{1} << 30U;  ///< of a file
inline constexpr std::size_t most_mesh_faces = 4'000'000;

/// The ending of a file's name in small letters, as `.stl`.
std::string ending_of(const std::filesystem::path& path);

/// The meshes of a file, by what its name ends with: .stl, .off, .obj, .amf or .3mf. An STL, OFF or OBJ file has one.
/// They are as the file has them: points may repeat, and nothing is checked but that numbers are finite and corners are
/// there. The text is the file's, and the name is for messages. Throws InputError that names the file, and the place in
/// it where there is one.
std::vector<Mesh> parse_meshes(std::string_view text, const std::filesystem::path& path);

/// STL, both kinds. Normals are not looked at, as in OpenSCAD. A text has triangles only.
Mesh parse_stl(std::string_view text, std::string_view name);

/// Object File Format in text. Colours and normals after a point's coordinates or a face's corners are not looked at.
Mesh parse_off(std::string_view text, std::string_view name);

/// Wavefront's OBJ, all of its objects. Its looks are passed over; curves and surfaces are refused.
Mesh parse_obj(std::string_view text, std::string_view name);

/// Additive Manufacturing File: a mesh an object, of all its volumes, which may be zipped. As in OpenSCAD, curved
/// triangles are flat, units and constellations are not looked at.
std::vector<Mesh> parse_amf(std::string_view text, std::string_view name);

/// 3D Manufacturing Format: a mesh an object that has one. As in OpenSCAD, units, components and the transforms of the
/// build are not looked at.
std::vector<Mesh> parse_3mf(std::string_view text, std::string_view name);

}  // namespace csgsim::solids
