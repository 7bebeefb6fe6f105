#include "sim/session/options/version.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>

#include "sim/session/options/commit.h"

namespace csgsim::session {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t digits_shown = 16;

std::size_t aligned(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// The build ID in a segment of ELF notes, in hexadecimal; empty if absent.
std::string id_in(std::span<const std::byte> notes) {
  ElfW(Nhdr) header{};
  while (notes.size() >= sizeof header) {
    std::memcpy(&header, notes.data(), sizeof header);
    const std::size_t description = sizeof header + aligned(header.n_namesz);
    const std::size_t end = description + aligned(header.n_descsz);
    if (end > notes.size()) return {};
    const std::string_view name(reinterpret_cast<const char*>(notes.data() + sizeof header), header.n_namesz);
    if (header.n_type == NT_GNU_BUILD_ID && name == "GNU\0"sv) {
      std::string text;
      for (const std::byte byte : notes.subspan(description, header.n_descsz))
        text += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
      return text.substr(0, digits_shown);
    }
    notes = notes.subspan(end);
  }
  return {};
}

/// Whether the loaded object (the program, or a module of another program) contains this code.
bool is_own(const dl_phdr_info& object) {
  const auto here = reinterpret_cast<ElfW(Addr)>(&is_own);  // NOLINT
  return std::ranges::any_of(std::span(object.dlpi_phdr, object.dlpi_phnum), [&](const ElfW(Phdr) & segment) {
    const ElfW(Addr) begin = object.dlpi_addr + segment.p_vaddr;
    return segment.p_type == PT_LOAD && here >= begin && here - begin < segment.p_memsz;
  });
}

int find_id(dl_phdr_info* object, std::size_t /*size*/, void* found) {
  if (!is_own(*object)) return 0;
  for (const ElfW(Phdr) & segment : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
    if (segment.p_type != PT_NOTE) continue;
    // the loader has mapped the segment to this address
    const auto* const begin = reinterpret_cast<const std::byte*>(object->dlpi_addr + segment.p_vaddr);  // NOLINT
    const std::string id = id_in({begin, segment.p_memsz});
    if (!id.empty()) *static_cast<std::string*>(found) = id;
  }
  return 1;
}

/// The build ID in hexadecimal; empty if there is none.
std::string build_id() {
  std::string id;
  ::dl_iterate_phdr(find_id, &id);
  return id;
}

}  // namespace

std::string version() { return CSGSIM_VERSION; }

std::string version_and_build() {
  const std::string id = build_id();
  return version() + (id.empty() ? "" : " " + id);
}

std::string version_page() {
  const std::string id = build_id();
  return fmt::format("csgsim {}\ncommit {}, {}\nbuild {}\nbuilt with {}", version(), commit, commit_date,
                     id.empty() ? "unknown" : id, CSGSIM_BUILT_WITH);
}

std::string source_date() { return commit_date; }

}  // namespace csgsim::session
