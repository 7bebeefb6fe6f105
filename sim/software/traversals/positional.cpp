#include "sim/software/traversals/positional.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow positional_row{
    .name = "positional",
    .help = "visits only operands with a primitive that contains the point, found by codes",
    .source = "Jansen 1987, 4.3.3, table 4.4",
    .compiled = processors::Compiled::positional,
    .make = make_crossed<Positional>};

}  // namespace csgsim::software
