#include "sim/suite/program_text.h"

#include "hw/isa/text.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const std::string whole = R"(# csgsim program
.array width=8 height=8 memory_bits=72
.machine name="pixel-planes-4"
.frame colour_base=41 colour_bits=8 background=7
.depth perspective=true near=10.5 far=80
.model file="a;b#c.csg" primitives=2 unions=1
.compile strategy="stack" z_bits=20 effects=["shading"]
.field Z1 [0+:20] depth
.field colour [41+:8] colour
.primitive "wheel"
.primitive "tooth"

.segment x=0 y=0 width=8 height=8 primitives=2 halfspaces=12  # s0
  enable_all                                ; setup        # i0
  keep_max Z1, 12*x - 7*y + 91 (w35 >> 12)  ; render p0    # i1
  enable_load [70]                          ; classify p0 against p1
  set_constant colour, 255                  ; shade p0
)";

/// Only what machines act on, depths and names of fields.
const std::string bare = R"(# csgsim program
.array width=8 height=8 memory_bits=72
.frame colour_base=41 colour_bits=8 background=7
.depth perspective=true near=10.5 far=80
.field Z1 [0+:20] depth
.field colour [41+:8] colour
.segment x=0 y=0 width=8 height=8
enable_all
keep_max Z1, 12*x - 7*y + 91 (w35 >> 12)
enable_load [70]
set_constant colour, 255
)";

}  // namespace

TEST_CASE("the suite's text of a Program has what machines act on and names of fields") {
  CHECK(suite::text_of(isa::parse(whole, "whole")) == bare);
  CHECK(suite::text_of(isa::parse(bare, "bare")) == bare);
}

TEST_CASE("used bits are counted once, also those of the displayed field") {
  CHECK(suite::used_bits(isa::parse(whole, "whole")) == 20 + 8 + 1);
}
