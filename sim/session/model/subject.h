// Distinguishes models from Programs by content and name.
// Used by sim/session, sim/app, sim/python, sim/shell, sim/studies and sim/viewer.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace csgsim::session {

/// Kind of the input of a command.
enum class Subject : std::uint8_t {
  csg,       ///< a model exported by OpenSCAD
  scad,      ///< a model's source, evaluated by OpenSCAD
  commands,  ///< a model in the thesis's language of commands
  mesh,      ///< a model that is a mesh file
  program    ///< a compiled model, in binary or text form
};

/// A file extension and its kind of input.
struct NamedSubject {
  std::string_view ending;  ///< in lower case
  Subject subject;
};

inline constexpr auto named_subjects = std::to_array<NamedSubject>({{".csg", Subject::csg},
                                                                    {".scad", Subject::scad},
                                                                    {".jan", Subject::commands},
                                                                    {".stl", Subject::mesh},
                                                                    {".off", Subject::mesh},
                                                                    {".obj", Subject::mesh},
                                                                    {".ply", Subject::mesh},
                                                                    {".3mf", Subject::mesh},
                                                                    {".amf", Subject::mesh},
                                                                    {".csgt", Subject::program}});

/// Kind of an input; every command uses this function. A file that begins like a Program is one, regardless of its
/// name. Otherwise the extension decides, and an unknown extension stands for a model's text, as does standard input.
/// The content of a pipe is not inspected, since it can be read only once.
Subject detect_input_kind(const std::filesystem::path& path);

bool is_model(const std::filesystem::path& path);
bool is_program(const std::filesystem::path& path);

/// Whether the extension is that of a model.
bool has_model_name(const std::filesystem::path& path);

/// Whether the extension is that of a mesh.
bool has_mesh_name(const std::filesystem::path& path);

/// A sentence about the names of models: `models end in .csg, .scad, ...`.
std::string model_endings();

/// Throws InputError for a model, with advice, in commands that accept Programs only.
void refuse_model(const std::filesystem::path& path);

}  // namespace csgsim::session
