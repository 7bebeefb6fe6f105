#pragma once

#include <optional>
#include <string>

#include "hw/processors/processor.h"
#include "sim/software/draw.h"
#include "sim/software/methods/rows.h"

namespace csgsim::software {

/// What a picture takes by a method: counted, and measured on this computer. A method that takes intervals or planes
/// has no use for what comes before these, which counts nothing then.
struct Work {
  Picture picture;
  Counts counts;     ///< of classification
  RayCounts rays;    ///< of what rays meet, and of putting it in order
  Seconds measured;  ///< wall time
};

/// Draws the picture, once counting and then to take the time. Throws InputError as the method does.
Work work_of(const Choice& choice, const Subject& subject, const RayCaster& rays);

/// A processor that work is priced for.
struct Priced {
  std::string name;
  std::optional<processors::Processor> processor;  ///< nothing for this computer
};

/// By name, file or `this-computer`. Throws as load_processor does.
Priced priced(const std::string& said);

/// Of every figure, as machines have one; of this computer, of its name.
std::string hash_of(const Priced& processor);

/// Seconds of classifying alone, as the thesis tells them, and of all that the picture takes.
struct PricedSeconds {
  double classification = 0;
  double all = 0;
};

/// Operations of classification, and whose compiler's factor its traversal has.
struct Classifying {
  Operations operations;
  Operations traversal;  ///< of these
  processors::Compiled compiled = processors::Compiled::general;
};

/// Of operations on a processor, or of what was measured on this computer.
PricedSeconds seconds_of(const Operations& rays, const Operations& sorting, const Classifying& classification,
                         const Seconds& measured, const Priced& processor);

}  // namespace csgsim::software
