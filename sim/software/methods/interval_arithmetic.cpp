#include "sim/software/methods/interval_arithmetic.h"

#include "sim/software/methods/rows.h"
#include "sim/software/methods/whole.h"

namespace csgsim::software {

extern const MethodRow interval_arithmetic_row{.name = "interval-arithmetic",
                                               .help = "boxes are halved recursively, with trees pruned for each box",
                                               .source = "Keeter 2020; fidget",
                                               .takes = Takes::planes,
                                               .make = make_whole<IntervalArithmetic>};

}  // namespace csgsim::software
