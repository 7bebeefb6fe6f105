// Loads and saves Program files.
// Used by sim/session, sim/python and csgsim.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "hw/isa/program.h"

namespace csgsim::isa {

enum class ProgramForm : std::uint8_t { binary, text };

/// Whether a file that begins with these bytes is a Program. The text form is recognized by its first directive, after
/// blank lines and comments.
bool looks_like_program(std::span<const std::byte> first_bytes);

/// Reads a Program in either form, recognized by its first bytes. Throws InputError.
Program load_program(const std::filesystem::path& path);

/// Writes the whole Program or nothing (see OutputFile). Throws InputError.
void save_program(const Program& program, const std::filesystem::path& path, ProgramForm form = ProgramForm::binary);

}  // namespace csgsim::isa
