#include "hw/base/module.h"

#include <dlfcn.h>
#include <link.h>

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "hw/base/error.h"

namespace csgsim {

namespace {

/// The dynamic linker's search path for the object that contains this code: LD_LIBRARY_PATH, its run path and the
/// system's folders. The linker is queried for folders, not for the module, because a sanitizer that intercepts dlopen
/// would search the sanitizer's run path. Relative folders are dropped, so the current folder is never searched.
std::vector<std::filesystem::path> library_folders() {
  Dl_info unused{};
  void* object = nullptr;
  static const char here = 0;
  if (::dladdr1(&here, &unused, &object, RTLD_DL_LINKMAP) == 0) return {};
  Dl_serinfo size{};
  if (::dlinfo(object, RTLD_DI_SERINFOSIZE, &size) != 0) return {};
  const std::unique_ptr<std::byte[]> memory(new std::byte[size.dls_size]);  // NOLINT(modernize-avoid-c-arrays)
  auto* const info = ::new (memory.get()) Dl_serinfo{size};
  if (::dlinfo(object, RTLD_DI_SERINFOSIZE, info) != 0 || ::dlinfo(object, RTLD_DI_SERINFO, info) != 0) return {};
  std::vector<std::filesystem::path> folders;
  for (const Dl_serpath& path : std::span(&info->dls_serpath[0], info->dls_cnt)) {
    std::filesystem::path folder(path.dls_name);
    if (folder.is_absolute()) folders.push_back(std::move(folder));
  }
  return folders;
}

}  // namespace

std::filesystem::path find_module(const char* file) {
  for (const std::filesystem::path& folder : library_folders()) {
    std::error_code unused;
    if (std::filesystem::exists(folder / file, unused)) return folder / file;
  }
  return {};
}

std::string module_missing_text(const ModuleRole& role) {
  if (role.disabling_option != nullptr) {
    return std::string("this build of csgsim lacks ") + role.file + ", the part that " + role.does +
           "; build csgsim with -D" + role.disabling_option + "=ON" + role.instead;
  }
  return std::string(role.file) + ", the part of csgsim that " + role.does +
         ", was not found in the library search path; install csgsim completely (cmake --install)" + role.instead +
         ", or add its folder to LD_LIBRARY_PATH";
}

std::string module_unusable_text(const ModuleRole& role, const std::filesystem::path& file, const std::string& error) {
  return file.native() + ", the part of csgsim that " + role.does + ", cannot be opened: " + error +
         "; install csgsim completely (cmake --install)" + role.instead;
}

const void* load_module_symbol(const ModuleRole& role) {
  const std::filesystem::path file = find_module(role.file);
  if (file.empty()) throw InputError(module_missing_text(role));
  const OpenedModule opened = open_module(file, role.symbol);
  if (opened.symbol == nullptr) throw InputError(module_unusable_text(role, file, opened.error));
  return opened.symbol;
}

OpenedModule open_module(const std::filesystem::path& file, const char* symbol) {
  void* const library = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return {nullptr, ::dlerror()};
  const void* const address = ::dlsym(library, symbol);
  if (address == nullptr) return {nullptr, "it belongs to another version of csgsim"};
  return {address, {}};
}

}  // namespace csgsim
