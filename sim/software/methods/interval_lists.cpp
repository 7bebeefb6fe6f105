#include "sim/software/methods/interval_lists.h"

#include "sim/software/methods/rows.h"
#include "sim/software/methods/whole.h"

namespace csgsim::software {

extern const MethodRow interval_lists_row{.name = "interval-lists",
                                          .help = "each node merges its operands' intervals along the ray",
                                          .source = "Roth 1982; Jansen 1987, 4.1",
                                          .takes = Takes::intervals,
                                          .make = make_whole<IntervalLists>};

}  // namespace csgsim::software
