#pragma once

#include <cstdint>
#include <filesystem>

#include "hw/isa/program.h"

namespace csgsim::isa {

enum class ProgramForm : std::uint8_t { binary, text };

/// Reads a Program in either form; its first bytes tell which. Throws InputError.
Program load_program(const std::filesystem::path& path);

/// Writes the whole Program or nothing (see OutputFile). Throws InputError.
void save_program(const Program& program, const std::filesystem::path& path, ProgramForm form = ProgramForm::binary);

}  // namespace csgsim::isa
