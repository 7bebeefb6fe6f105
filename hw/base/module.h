#pragma once

#include <filesystem>
#include <string>

namespace csgsim {

// Modules are shared libraries of csgsim's own, of the same build as what opens them: for what is seldom asked for, and
// whose libraries take longer to load than most runs take.

/// Where the dynamic linker looks for libraries of this program; empty if the module is in none of those folders.
std::filesystem::path find_module(const char* file);

struct OpenedModule {
  const void* symbol = nullptr;  ///< null if it could not be opened, or has no such symbol
  std::string error;             ///< why
};

/// The symbol that the module has for others.
OpenedModule open_module(const std::filesystem::path& file, const char* symbol);

/// A module and what it is for, for messages.
struct ModuleRole {
  const char* file = nullptr;
  const char* symbol = nullptr;
  const char* does = nullptr;  ///< the part of csgsim that ...
  const char* instead = "";    ///< what else could be done, if there is something: ", or write .png"
};

/// Why it cannot be used, and what to do: that it is nowhere, or that it could not be opened.
std::string no_module(const ModuleRole& role);
std::string unusable_module(const ModuleRole& role, const std::filesystem::path& file, const std::string& error);

/// Its symbol. Throws InputError with one of these.
const void* module_symbol_of(const ModuleRole& role);

}  // namespace csgsim
