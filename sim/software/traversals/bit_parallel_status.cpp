#include "sim/software/traversals/bit_parallel_status.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow bit_parallel_status_row{
    .name = "bit-parallel-status",
    .help = "like bit-parallel, but evaluates only the words above a changed bit",
    .source = "Jansen 1987, named in table 4.10",
    .compiled = processors::Compiled::bit_parallel,
    .make = make_crossed<BitParallelStatus>};

}  // namespace csgsim::software
