// Measurement of designs: counts, timing, prices and errors.
// Used by sweep, accuracy, advise and explore.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "hw/process/process.h"
#include "sim/judges/truth.h"
#include "sim/observe/frame.h"
#include "sim/studies/design/row.h"
#include "sim/studies/fitted_program.h"
#include "sim/studies/jobs.h"
#include "sim/studies/memo.h"

namespace csgsim::studies {

/// Maximum memory bits per pixel of a Program whose machine gets exactly the bits that it uses.
inline constexpr std::uint32_t max_fitted_bits = 512;

/// Replaces the hash of a picture if a linear expression exceeded its width, which is an error of the Program.
inline constexpr std::string_view overflow = "overflow";

/// A Program that was run at the functional level.
struct DrawnProgram {
  isa::Program program;
  observe::Frame frame;
  machines::FrameTiming timing;
  bool has_overflow = false;
};

DrawnProgram draw(isa::Program program, const machines::Machine& machine);

/// Compiles the point with the memory of its job, counts its work, and draws it if `is_drawn`. Clocks are measured by a
/// run.
DesignRow measure_picture(const DesignPoint& point, const Job& job, bool is_drawn);

/// Settings of a measurement of designs.
struct MeasurementSettings {
  std::uint32_t max_bits = max_fitted_bits;  ///< maximum memory bits per pixel of a Program
  std::vector<unsigned> colour_bits{};  ///< all numbers of colour bits of the designs, if colour errors are requested
};

/// Measures designs; thread-safe. Results that several designs share are computed once: exact pictures of models,
/// errors of pictures, and outcomes of runs.
class DesignMeter {
 public:
  explicit DesignMeter(MeasurementSettings question = {}) : question_(std::move(question)) {}

  /// Measures a point. Without memory bits, the machine gets exactly the bits that the Program uses. The process, if
  /// any, sets the clock rate and the prices of the machine. If the model does not fit, the row holds the reason.
  DesignRow measure(const DesignPoint& point, const Job& job, const process::Process* process = nullptr);

 private:
  struct PixelErrors {
    std::uint64_t wrong = 0;
    std::uint64_t unexplained = 0;
    unsigned colour_error = 0;
  };
  /// Errors by number of colour bits; by 0 if colour errors are not requested.
  using ErrorsByColour = std::map<unsigned, PixelErrors>;
  /// Model, with its surfaces faceted or curved, and width and height of a picture.
  using PictureKey = std::tuple<const Subject*, std::uint32_t, std::uint32_t>;
  /// Everything on which a picture depends: the key above, z bits and fraction bits. Strategy, colouring, pruning and
  /// machine do not change a picture (docs/machines.md).
  using PictureBitsKey = std::tuple<PictureKey, unsigned, unsigned>;

  FittedProgram fit_memory(const DesignPoint& point, const Job& job);
  void judge_picture(const DesignPoint& point, const Job& job, const FittedProgram& fitted, DesignRow& row);
  PixelErrors pixel_errors_of(const Job& job, const DrawnProgram& drawn);
  ErrorsByColour errors_by_colour(const DesignPoint& point, const Job& job);
  const judges::Truth& truth_of(const Job& job, const isa::Program& program);

  MeasurementSettings question_;
  RunTimer timer_;
  Memo<PictureKey, judges::Truth> truths_;
  Memo<PictureBitsKey, ErrorsByColour> errors_;
  std::mutex lock_;  ///< guards bits_
  std::map<DesignPoint, std::pair<unsigned, std::uint32_t>>
      bits_;  ///< by the point without colours and ALU: colour bits, and total bits
};

}  // namespace csgsim::studies
