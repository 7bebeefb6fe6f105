#include "sim/software/traversals/bit_parallel.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow bit_parallel_row{.name = "bit-parallel",
                                        .help = "evaluates all nodes of a level at once, in words of 32 bits",
                                        .source = "Jansen 1987, 4.4.2, table 4.7",
                                        .compiled = processors::Compiled::bit_parallel,
                                        .make = make_crossed<BitParallel>};

}  // namespace csgsim::software
