// Writes waveform files, VCD or FST.
// Used by sim/app.
#pragma once

#include <optional>
#include <string_view>

#include "hw/base/output_file.h"
#include "sim/system/memory_file.h"

namespace csgsim::waves {

/// Receives a value change dump in pieces and writes it to the file, directly or converted to GTKWave's format FST by
/// vcd2fst.
class WaveFile {
 public:
  /// The file has to outlive this object. Throws InputError if memory for the dump is not available.
  WaveFile(OutputFile& file, bool is_fst);

  void write(std::string_view text);

  /// Called after the last piece. Throws InputError if vcd2fst cannot be run or fails.
  void finish();

 private:
  OutputFile& file_;
  std::optional<system::MemoryFile> dump_;  ///< input of vcd2fst
};

}  // namespace csgsim::waves
