#include "sim/software/traversals/bit_sequential.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow bit_sequential_row{.name = "bit-sequential",
                                          .help = "steps over a string of bits, with a stack of bits",
                                          .source = "Jansen 1987, 4.4.1, table 4.6",
                                          .make = make_crossed<BitSequential>};

}  // namespace csgsim::software
