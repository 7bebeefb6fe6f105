// Loads csgsim's own shared libraries on demand.
// Used by host/flat, sim/pictures, sim/viewer and sim/web.
#pragma once

#include <filesystem>
#include <string>

namespace csgsim {

// Modules are csgsim's own shared libraries, of the same build as the program that opens them. They hold features that
// are rarely used and whose libraries take longer to load than most runs take.

/// The module's path in the dynamic linker's search path for this program; empty if the module is not there.
std::filesystem::path find_module(const char* file);

struct OpenedModule {
  const void* symbol = nullptr;  ///< null if the module could not be opened or does not define the symbol
  std::string error;             ///< reason if `symbol` is null
};

/// Opens a module and looks up the symbol it exports.
OpenedModule open_module(const std::filesystem::path& file, const char* symbol);

/// A module and its purpose, for messages.
struct ModuleRole {
  const char* file = nullptr;
  const char* symbol = nullptr;
  const char* does = nullptr;  ///< completes "the part of csgsim that ..."
  const char* instead = "";    ///< an alternative, as in ", or write .png"; may be empty
  const char* disabling_option =
      nullptr;  ///< the CMake option that left the module out of this build; null if none did
};

/// Error texts for a module that was not found or could not be opened: the cause and what to do.
std::string module_missing_text(const ModuleRole& role);
std::string module_unusable_text(const ModuleRole& role, const std::filesystem::path& file, const std::string& error);

/// The symbol that the module exports. Throws InputError with one of the texts above.
const void* load_module_symbol(const ModuleRole& role);

}  // namespace csgsim
