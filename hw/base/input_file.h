// Reads input files with a size limit.
// Used by hw/isa, hw/kinds, hw/machines, host/read, host/solids and sim.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "hw/base/descriptor.h"

namespace csgsim {

/// Name, size limit and advice for one kind of input file.
struct InputKind {
  std::string_view what;  ///< name in messages, as in "name a .csg file"
  std::size_t max_bytes = 0;
  std::string_view advice;    ///< what to do if the file is too long, as in "split the model"
  bool is_continued = false;  ///< the command continues this file, so its output may replace it (inputs_kept.h)
};

/// Reads a whole file, which may be a pipe or a device. `-` is standard input, which is cached so that it can be read
/// again. Throws InputError if the file cannot be read, is longer than the limit or does not fit into memory.
std::string read_file(const std::filesystem::path& path, const InputKind& kind);

/// Reads a whole regular file whose name did not come from the command line. Rejects pipes and devices instead of
/// waiting for their data.
std::string read_regular_file(const std::filesystem::path& path, const InputKind& kind);

/// The two steps of read_regular_file(). The descriptor is closed if the file does not exist. Throws InputError if the
/// path is not a regular file or cannot be opened.
Descriptor open_regular_file(const std::filesystem::path& path, const InputKind& kind);
std::string read_file(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind);

/// Throws the InputError of read_file() if `byte_count` exceeds the limit of the kind.
void check_length(std::string_view name, std::size_t byte_count, const InputKind& kind);

}  // namespace csgsim
