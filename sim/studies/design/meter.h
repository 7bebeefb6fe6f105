#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/process/process.h"
#include "sim/judges/truth.h"
#include "sim/observe/frame.h"
#include "sim/studies/design/row.h"
#include "sim/studies/fitted_program.h"
#include "sim/studies/jobs.h"
#include "sim/studies/memo.h"

namespace csgsim::studies {

/// Memory bits a pixel that a Program may take where its machine is given as many as it takes.
inline constexpr std::uint32_t most_fitted_bits = 512;

/// Stands for the hash of a picture where a linear expression did not fit its width: a fault of the Program.
inline constexpr std::string_view overflow = "overflow";

/// A Program that was run at the functional level.
struct DrawnProgram {
  isa::Program program;
  observe::Frame frame;
  std::uint64_t clocks = 0;
  bool has_overflow = false;
};

DrawnProgram draw(isa::Program program, const machines::Machine& machine);

/// Compiles the point with the memory of its job, counts, and, if asked to, draws it. The clocks are those of a run.
DesignRow measure_picture(const DesignPoint& point, const Job& job, bool is_drawn);

/// What is measured of designs.
struct DesignQuestion {
  std::uint32_t most_bits = most_fitted_bits;  ///< a pixel, that a Program may take
  std::optional<process::Process> process{};   ///< whose clock machines have, and in which they are priced
  std::vector<unsigned> colour_bits{};         ///< all that designs have, where errors of colours are asked for
};

/// Measures designs, on several threads at the same time. What is the same for many of them is worked out once: the
/// exact picture of a model, how far that of a machine is from it, what a run of a Program tells.
class DesignMeter {
 public:
  explicit DesignMeter(DesignQuestion question = {}) : question_(std::move(question)) {}

  /// Where the point does not say how many memory bits its machine has, it is given just as many as its Program takes.
  /// A model that does not fit is a row that says why.
  DesignRow measure(const DesignPoint& point, const Job& job);

 private:
  struct PixelErrors {
    std::uint64_t wrong = 0;
    std::uint64_t unexplained = 0;
    unsigned colour_error = 0;
  };
  /// By colour bits; by 0 where errors of colours are not asked for.
  using ErrorsByColour = std::map<unsigned, PixelErrors>;
  /// A model's surfaces, as facets or curved, and a size.
  using Seen = std::tuple<const Subject*, std::uint32_t, std::uint32_t>;
  /// With these and with z bits and fraction bits, every strategy, colouring and pruning draws the same on every
  /// machine (docs/machines.md).
  using SeenBits = std::tuple<Seen, unsigned, unsigned>;

  Fitted fitted(const DesignPoint& point, const Job& job);
  void judge(const DesignPoint& point, const Job& job, const Fitted& fitted, DesignRow& row);
  PixelErrors errors_of(const Job& job, const DrawnProgram& drawn);
  ErrorsByColour errors_by_colour(const DesignPoint& point, const Job& job);
  const judges::Truth& truth_of(const Job& job, const isa::Program& program);

  DesignQuestion question_;
  RunTimer timer_;
  Memo<Seen, judges::Truth> truths_;
  Memo<SeenBits, ErrorsByColour> errors_;
  std::mutex lock_;                                                 ///< of the following
  std::map<DesignPoint, std::pair<unsigned, std::uint32_t>> bits_;  ///< but colours and ALU: colour bits, bits in all
};

}  // namespace csgsim::studies
