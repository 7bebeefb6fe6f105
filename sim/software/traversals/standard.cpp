#include "sim/software/traversals/standard.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow standard_row{.name = "standard",
                                    .help = "evaluates the whole tree in postorder",
                                    .source = "Jansen 1987, 4.3.1, table 4.2",
                                    .compiled = processors::Compiled::standard,
                                    .make = make_crossed<Standard>};

}  // namespace csgsim::software
