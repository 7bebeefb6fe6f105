#pragma once

/// Headers for a program that reads a model, compiles it for a machine, runs it and inspects the results; see
/// docs/install.md. Link csgsim::csgsim.

#include "host/emit/compile.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/pictures.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
