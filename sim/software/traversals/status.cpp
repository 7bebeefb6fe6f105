#include "sim/software/traversals/status.h"

#include "sim/software/methods/crossed.h"

namespace csgsim::software {

extern const MethodRow status_row{
    .name = "status",
    .help = "stores the status of nodes; propagates a change upwards until a node is unchanged",
    .source = "Sato et al. 1985; Jansen 1987, 4.3.4, table 4.5",
    .compiled = processors::Compiled::status,
    .make = make_crossed<StatusTree>};

}  // namespace csgsim::software
