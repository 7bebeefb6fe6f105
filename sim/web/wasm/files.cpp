// Replaces hw/base/input_file.cpp, descriptor.cpp and standard_streams.cpp: the only files are those handed over by the
// page.
#include "sim/web/wasm/files.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/standard_streams.h"

namespace csgsim {

namespace {

std::map<std::string, std::string>& files() {
  static std::map<std::string, std::string> kept;
  return kept;
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw InputError(
      fmt::format("{}: a page in a browser cannot read files; use csgsim on your computer", path.native()));
}

}  // namespace

namespace web {

void keep_file(std::string name, std::string text) { files()[std::move(name)] = std::move(text); }

}  // namespace web

std::string read_file(const std::filesystem::path& path, const InputKind& kind) {
  const auto file = files().find(path.native());
  if (file == files().end()) refuse(path);
  check_length(path.native(), file->second.size(), kind);
  return file->second;
}

std::string read_regular_file(const std::filesystem::path& path, const InputKind& kind) {
  return read_file(path, kind);
}

Descriptor open_regular_file(const std::filesystem::path& path, const InputKind& /*kind*/) { refuse(path); }

std::string read_file(const Descriptor& /*file*/, const std::filesystem::path& path, const InputKind& /*kind*/) {
  refuse(path);
}

std::error_code Descriptor::close() { return {}; }

/// Prints go to the browser's console.
void silence_prints() {}

}  // namespace csgsim
