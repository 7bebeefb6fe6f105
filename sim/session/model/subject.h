#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace csgsim::session {

/// What a command is given to draw.
enum class Subject : std::uint8_t {
  csg,       ///< a model as OpenSCAD exports it
  scad,      ///< a model's source, which OpenSCAD evaluates
  commands,  ///< a model in the thesis's language of commands
  program    ///< compiled, in binary or in text form
};

/// What the ending of a name says.
struct NamedSubject {
  std::string_view ending;  ///< in small letters
  Subject subject;
};

inline constexpr auto named_subjects = std::to_array<NamedSubject>(
    {{".csg", Subject::csg}, {".scad", Subject::scad}, {".jan", Subject::commands}, {".csgt", Subject::program}});

/// The one place where it is decided. A file that begins as a Program does is one, whatever its name; any other is what
/// its name's ending says, and a model's text if that says nothing. Standard input has no name; of a pipe the name
/// alone is looked at, since it can be read only once.
Subject subject_in(const std::filesystem::path& path);

bool is_model(const std::filesystem::path& path);
bool is_program(const std::filesystem::path& path);

/// Does the name end as a model's?
bool has_model_name(const std::filesystem::path& path);

/// Of a command that takes Programs alone: throws InputError, with what to do, for a model.
void refuse_model(const std::filesystem::path& path);

}  // namespace csgsim::session
