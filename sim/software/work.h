// Cost of drawing a picture by software.
// Used by sim/studies.
#pragma once

#include <optional>
#include <string>

#include "hw/processors/processor.h"
#include "sim/software/draw.h"
#include "sim/software/methods/rows.h"

namespace csgsim::software {

/// The cost of a picture drawn by a method: operation counts, and the time measured on this computer. If a method takes
/// intervals or planes, the preceding stages are not needed and count nothing.
struct Work {
  Picture picture;
  Counts counts;     ///< classification
  RayCounts rays;    ///< ray intersection and sorting
  Seconds measured;  ///< wall time
};

/// Draws the picture once to count operations, then measures the time. Throws InputError if the
/// method cannot draw it, for instance because the tree has too many levels.
Work work_of(const Choice& choice, const Subject& subject, const RayCaster& rays);

/// A processor for which costs are computed.
struct Priced {
  std::string name;
  std::optional<processors::Processor> processor;  ///< empty for this computer
};

/// Loads a processor by name or file, or `this-computer`. Throws as load_processor does.
Priced load_priced(const std::string& name);

/// Hash of the processor's name and all its parameters; for this computer, of the name only.
std::string hash_of(const Priced& processor);

/// Seconds of classification alone, as given in the thesis, and of the whole picture.
struct PricedSeconds {
  double classification = 0;
  double all = 0;
};

/// Operations of classification, and the compiler whose factor applies to the traversal.
struct Classifying {
  Operations operations;
  Operations traversal;  ///< subset of `operations`
  processors::Compiled compiled = processors::Compiled::general;
};

/// Seconds computed from operations for a processor, or measured on this computer.
PricedSeconds seconds_of(const Operations& rays, const Operations& sorting, const Classifying& classification,
                         const Seconds& measured, const Priced& processor);

}  // namespace csgsim::software
