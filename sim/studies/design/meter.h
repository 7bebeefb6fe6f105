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
  std::vector<unsigned> colour_bits{};         ///< every value that designs have, if errors of colours are wanted
};

/// Measures designs, on several threads at the same time. Results that several designs share are computed
/// once: the exact picture of a model, the errors of a picture, the outcome of a run.
class DesignMeter {
 public:
  explicit DesignMeter(DesignQuestion question = {}) : question_(std::move(question)) {}

  /// A point without memory bits gets a machine with exactly the bits that its Program takes. The row of a model that
  /// does not fit has the reason.
  DesignRow measure(const DesignPoint& point, const Job& job);

 private:
  struct PixelErrors {
    std::uint64_t wrong = 0;
    std::uint64_t unexplained = 0;
    unsigned colour_error = 0;
  };
  /// The key is the number of colour bits; 0 if errors of colours are not wanted.
  using ErrorsByColour = std::map<unsigned, PixelErrors>;
  /// A model's surfaces, as facets or curved, and a size.
  using Seen = std::tuple<const Subject*, std::uint32_t, std::uint32_t>;
  /// The picture depends on these, z bits and fraction bits alone: not on strategy, colouring, pruning or machine
  /// (docs/machines.md).
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
