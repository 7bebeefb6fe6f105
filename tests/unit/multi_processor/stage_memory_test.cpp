#include <rapidcheck.h>

#include "hw/isa/host_counts.h"
#include "hw/machines/runs_on.h"
#include "tests/support/test.h"
#include "tests/unit/multi_processor/stage_timing.h"

using namespace csgsim;
using namespace csgsim::testing::stages;

TEST_CASE("lists beyond the nodes' memory are sent and rendered in parts (by hand)") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount whole = account_of(program, machine);
  CHECK(whole.list_passes == 1);
  // Words of 16 bits: the frame takes 16 + 2 * 5 + 3, the segment 1 + 1 + 3; lists begin with 5 and end with 1,
  // instructions take 1 and 6. The sender stops where fewer than 16 of 32 words are left next to the 6 of a waiting
  // list: before the end of the first list and, as the last list waits, before the end of the third, which has received
  // no instruction.
  figures(machine).memory_words = 34 + 32;
  const FrameAccount account = account_of(program, machine);
  CHECK(account.list_passes == 3);
  CHECK(account.shared_words == whole.shared_words + 2);
  CHECK(account.stages.sharing == 6 * 4 + 22 * 10);
  CHECK(account.stages.barriers == whole.stages.barriers + 2 * 6);
  CHECK(account.stages.second_pruning == whole.stages.second_pruning);
  CHECK(account.stages.rendering == whole.stages.rendering);
  CHECK(clocks_of(program, machine) == 3613 + 2 * 4 + 2 * 10 + 2 * 6);
}

TEST_CASE("a list beyond half of a node's free memory is made in parts (by hand)") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  isa::Segment& first = program.segments.front();
  first.instructions.push_back(first.instructions.back());
  first.division->steps.front().instructions = 3;
  const FrameAccount whole = account_of(program, machine);
  figures(machine).memory_words = 34 + 32;
  const FrameAccount account = account_of(program, machine);
  // 5 + 1 + 6 words of 16, then 6 + 1; the other lists wait meanwhile.
  const std::uint64_t before = 29 + 3 * 31 + 47 + 2 * 53 + 2 * 59;
  CHECK(whole.stages.second_pruning == before + 59);
  CHECK(account.stages.second_pruning == before + 59);
  CHECK(account.nodes[0].of(NodeActivity::pruning) == before + 59);
  CHECK(account.stages.sharing > whole.stages.sharing);
  CHECK(account.stages.rendering == whole.stages.rendering);
}

TEST_CASE("sending lists in parts takes longer with less memory and completes all work") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    const isa::Program program = any_program(machine);
    const FrameAccount whole = account_of(program, machine);
    figures(machine).memory_words = *rc::gen::inRange<std::uint32_t>(100, 5000);
    try {
      machines::check_runs_on(program, machine);
    } catch (const InputError&) {
      return;
    }
    const FrameAccount parts = account_of(program, machine);
    RC_ASSERT(parts.list_passes >= whole.list_passes);
    RC_ASSERT(parts.shared_words >= whole.shared_words);
    RC_ASSERT(parts.stages.rendering >= whole.stages.rendering);
    RC_ASSERT(parts.stages.second_pruning >= whole.stages.second_pruning);
    RC_ASSERT(spent(parts, NodeActivity::pruning) >= spent(whole, NodeActivity::pruning));
    RC_ASSERT(parts.second_halfspace_tests == whole.second_halfspace_tests);
    RC_ASSERT(clocks_of(program, machine) >= parts.stages.rendering + parts.stages.second_pruning);
  }));
}

TEST_CASE("nodes read half-spaces beyond their memory over the bus in turn (by hand)") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount whole = account_of(program, machine);
  // One word less than the records, 34, and two commands of at most 256 bits.
  figures(machine).memory_words = 34 + 32 - 1;
  const FrameAccount account = account_of(program, machine);
  // Three half-spaces are tested: each takes a request and an answer of one word, both after the bus latency.
  const std::uint64_t reads = 3 * 2 * (4 + 10);
  CHECK(account.stages.second_pruning == whole.stages.second_pruning + reads + 3 * 29);
  CHECK(account.stages.broadcasting == whole.stages.broadcasting - 3 * 10);
  CHECK(account.broadcast_words == whole.broadcast_words);
  CHECK(account.broadcast_halfspaces == 3);
  CHECK(account.shared_words == whole.shared_words + 3);
  CHECK(account.list_passes == 4);
  CHECK(account.stages.sharing == whole.stages.sharing);
  CHECK(account.stages.rendering == whole.stages.rendering);
  CHECK(clocks_of(program, machine) == 3613 + reads + 3 * 29 - 3 * 10);
}

TEST_CASE("a segment whose primitives leave no room for two commands in a node is rejected") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  figures(machine).memory_words = 31 + 32;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  --figures(machine).memory_words;
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the segment at 0,0 needs 63 words of a node at once, but the nodes of four have 62; increase "
                       "node.memory_words or subdivision.levels in the machine file",
                       InputError);
}

TEST_CASE("records beyond the display processor are read from the host or tested twice") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const std::uint64_t once = 2 * 37 + 3 * 41 + 2 * 61;
  // Room for the model and 5 words of records.
  figures(machine).display_memory_words = 32 + 5;
  CHECK(account_of(program, machine).stages.first_pruning == once);
  --figures(machine).display_memory_words;
  CHECK(account_of(program, machine).stages.first_pruning == 2 * once);
  CHECK(account_of(program, machine).first_halfspace_tests == 6);
  CHECK(clocks_of(program, machine) == 3613 + once);
  // Its planes, 24 bits of 504, are absent: each takes a word of the host's link and is transformed.
  figures(machine).display_memory_words = 31;
  CHECK(account_of(program, machine).stages.first_pruning == 2 * (once + 3 * (5 + 3 + 43)));
  CHECK(account_of(program, machine).stages.transformation == 0);
  CHECK(account_of(program, machine).model_words == 32);
}

TEST_CASE("a model that exceeds the display processor even without its planes is rejected") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  figures(machine).display_memory_words = 30;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  --figures(machine).display_memory_words;
  CHECK_THROWS_WITH_AS(
      machines::check_runs_on(program, machine),
      "the model without its planes needs 30 words, but the display processor of four has 29; increase "
      "display.memory_words in the machine file, or use a model with fewer faces",
      InputError);
  figures(machine).display_memory_words = 36;
  figures(machine).memory_words = 34 + 32 - 1;
  CHECK_THROWS_WITH_AS(
      machines::check_runs_on(program, machine),
      "what remains of the model in the segment at 0,0 fits neither the memory of the nodes of four nor that of its "
      "display processor; increase node.memory_words, display.memory_words or subdivision.levels in "
      "the machine file",
      InputError);
  program.display_model.clear();
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the Program has no display model for four to divide; compile the model for this machine",
                       InputError);
}
