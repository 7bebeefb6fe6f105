#pragma once

#include <optional>
#include <string_view>

#include "hw/base/output_file.h"
#include "sim/system/memory_file.h"

namespace csgsim::waves {

/// Takes a value change dump piece by piece, to the file, or to one in GTKWave's format FST, which vcd2fst makes of it.
class WaveFile {
 public:
  /// The file has to live as long as this one. Throws InputError where there is no room.
  WaveFile(OutputFile& file, bool is_fst);

  void write(std::string_view text);

  /// After the last piece. Throws InputError if vcd2fst cannot be run or does not do its work.
  void finish();

 private:
  OutputFile& file_;
  std::optional<system::MemoryFile> dump_;  ///< for vcd2fst
};

}  // namespace csgsim::waves
