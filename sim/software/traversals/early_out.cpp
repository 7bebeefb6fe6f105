#include "sim/software/traversals/early_out.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow early_out_row{.name = "early-out",
                                     .help = "skips the right operand if the left one decides",
                                     .source = "Roth 1982; Jansen 1987, 4.3.2, table 4.3",
                                     .compiled = processors::Compiled::early_out,
                                     .make = make_crossed<EarlyOut>};

}  // namespace csgsim::software
