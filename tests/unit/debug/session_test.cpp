#include "sim/debug/session.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/text.h"
#include "sim/debug/completion.h"
#include "sim/debug/condition.h"
#include "sim/debug/field_picture.h"
#include "tests/support/planes_machine.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using csgsim::testing::error_of;
using testing::planes;

namespace {

/// Two primitives: columns from 3 at depth 40, then columns below 6 at depth x + 20. The query finds no enabled pixel.
constexpr const char* two_primitives =
    R"(.array width=8 height=2 memory_bits=24
.frame colour_base=16 colour_bits=6
.field Z2 [0+:8] depth
.field Z1 [8+:8] candidate_depth
.field colour [16+:6] colour
.field "a b" [22] mask
.primitive "near"
.primitive "far"
.segment x=0 y=0 width=8 height=2
  enable_all                    ; setup
  set_constant Z2, 255          ; setup
  set_constant colour, 63       ; setup
  edge_not_negative x - 3 (w8)  ; render p0
  set_constant Z1, 40           ; render p0
  copy Z2, Z1                   ; merge p0
  set_constant colour, 12       ; shade p0
  enable_all                    ; render p1
  edge_negative x - 6 (w8)      ; render p1
  load_linear Z1, x + 20 (w12)  ; render p1
  field_lt Z1, Z2               ; merge p1
  copy Z2, Z1                   ; merge p1
  set_constant colour, 48       ; shade p1
  edge_negative x (w8)          ; setup
  skip_if_none 2                ; setup
  set_constant colour, 0        ; setup
  enable_all                    ; setup
  enable_store "a b"            ; setup
)";

/// A session with its Program and machine.
struct Debugger {
  explicit Debugger(isa::Program of)
      : program(std::move(of)), machine(planes(program.shape)), session(program, machine) {}
  explicit Debugger(const char* text = two_primitives) : Debugger(isa::parse(text, "test")) {}

  std::string operator()(const std::string& line) {
    return session.execute(debug::parse_command(line, "test", 1, program));
  }
  std::string error(const std::string& line) {
    return error_of([&] { (*this)(line); });
  }

  isa::Program program;
  machines::Machine machine;
  debug::Session session;
};

const std::string last = "at the end, after i17\n";

}  // namespace

TEST_CASE("the debugger steps through instructions and past skipped ones to the end") {
  Debugger debug;
  CHECK(debug("step") == "i1 of 18: set_constant Z2, 255\n");
  CHECK(debug("step 3") == "i4 of 18: set_constant Z1, 40\n");
  CHECK(debug("print E") == "E = 1 at 10 of 16 pixels\n");
  CHECK(debug("step 11") == "i17 of 18: enable_store \"a b\"\n");
  CHECK(debug("step") == last);
  CHECK(debug("step") == last);
  CHECK(debug("run") == last);
}

TEST_CASE("the debugger shows its position in Programs of one instruction and of none") {
  const std::string none = ".array width=8 height=2 memory_bits=24\n.segment x=0 y=0 width=8 height=2\n";
  CHECK(Debugger(none.c_str())("where") == "the Program has no instructions\n");
  CHECK(Debugger((none + "  enable_all\n").c_str())("where").starts_with("i0 of 1: enable_all\n"));
}

TEST_CASE("the command until stops at an instruction or primitive or reports it unreachable") {
  Debugger debug;
  CHECK(debug("until i4") == "i4\ni4 of 18: set_constant Z1, 40\n");
  CHECK(debug.error("until i4") == "i4 is not ahead; step back first with back N");
  CHECK(debug.error("until i18") == "there is no instruction i18: the Program has 18, counted from i0");
  CHECK(debug("until primitive far") == "primitive p1 far\ni7 of 18: enable_all\n");
  CHECK(debug("until primitive 1") == "primitive p1 far was not reached\n" + last);
  CHECK(debug("back 100") == "i0 of 18: enable_all\n");
  CHECK(debug("until primitive p0") == "primitive p0 near\ni3 of 18: edge_not_negative x - 3 (w8)\n");
  CHECK(debug("until i15") == "i15\ni17 of 18: enable_store \"a b\"\n");  // i15 is skipped
}

TEST_CASE("the command until stops at the instruction that makes a pixel condition true") {
  Debugger debug;
  CHECK(debug("until Z2[5,1] == 40") == "Z2[5,1] == 40\ni6 of 18: set_constant colour, 12\n");
  CHECK(debug("until Z2[5,1] <= 40") == "Z2[5,1] <= 40 already holds\ni6 of 18: set_constant colour, 12\n");
  CHECK(debug("until Z2[5,1] < 40") == "Z2[5,1] < 40\ni12 of 18: set_constant colour, 48\n");
  CHECK(debug("print Z2[5,1]") == "Z2[5,1] = 25 (0x19)\n");
  CHECK(debug("until not E[5,1]") == "E[5,1] == 0\ni14 of 18: skip_if_none 2\n");
  CHECK(debug("until E[5,1]") == "E[5,1] != 0 was not reached\n" + last);
  debug("back 100");
  CHECK(debug("until change Z2[1,0]") == "change Z2[1,0]\ni2 of 18: set_constant colour, 63\n");
  CHECK(debug("until change Z2[1,0]") == "change Z2[1,0]\ni12 of 18: set_constant colour, 48\n");
  CHECK(debug("until change Z2[1,0]") == "change Z2[1,0] was not reached\n" + last);
  debug("back 100");
  CHECK(debug("until [16+:2][7,0] != 0x3") == "[16+:2][7,0] != 3 already holds\ni0 of 18: enable_all\n");
  debug("step 3");
  CHECK(debug("until [16+:2][7,0] != 0x3") == "[16+:2][7,0] != 3\ni7 of 18: enable_all\n");
}

TEST_CASE("breakpoints of the debugger stop every run until deleted and may coincide") {
  Debugger debug;
  CHECK(debug("breakpoints") == "no breakpoints\n");
  CHECK(debug("break i5") == "breakpoint 1: i5\n");
  CHECK(debug("break Z1[4,0] > 30") == "breakpoint 2: Z1[4,0] > 30\n");
  CHECK(debug("break change colour[4,0]") == "breakpoint 3: change colour[4,0]\n");
  CHECK(debug("run") == "breakpoint 3: change colour[4,0]\ni3 of 18: edge_not_negative x - 3 (w8)\n");
  CHECK(debug("run") == "breakpoint 1: i5\nbreakpoint 2: Z1[4,0] > 30\ni5 of 18: copy Z2, Z1\n");
  CHECK(debug("delete 3") == "");
  CHECK(debug("delete 1") == "");
  CHECK(debug.error("delete 1") == "there is no breakpoint 1; breakpoints lists them");
  CHECK(debug("breakpoints") == "  2  Z1[4,0] > 30\n");
  CHECK(debug("run") == last);
}

TEST_CASE("the debugger prints a pixel's fields by name with colours and reserved values") {
  Debugger debug;
  debug("until i5");
  CHECK(debug("print 4,1") ==
        "  E            1\n  Z2           255 (0xff), nothing\n  Z1           40 (0x28)\n"
        "  colour       63 (0x3f), #ffffff\n  \"a b\"        0\n");
  CHECK(debug("print E[2,1]") == "E[2,1] = 0\n");
  CHECK(debug("print \"a b\"[2,1]") == "\"a b\"[2,1] = 0\n");
  CHECK(debug("list i0").starts_with("> i0       enable_all"));
  CHECK(debug("where").starts_with("i5 of 18: copy Z2, Z1\n  merge p0 near: depth test against Z2"));
}

TEST_CASE("errors in debugger commands show the column and suggest the nearest name") {
  Debugger debug;
  const std::array<std::pair<const char*, const char*>, 9> lines{{
      {"  frobnicate", "test:1:3: unknown command 'frobnicate'; help lists the commands"},
      {"print Z3[1,1]", "test:1:7: there is no field 'Z3'; the nearest is 'Z2'"},
      {"print Z2[8,1]", "test:1:12: there is no pixel 8,1 in a picture of 8 x 2"},
      {"print Z2", "test:1:9: the line ends; expected a pixel of the field, as in Z2[100,20]"},
      {"until Z2[1,1] < ", "test:1:17: the line ends; expected a number to compare with, as in 5000 or 0xff"},
      {"until primitive nera", "test:1:17: there is no primitive 'nera'; the nearest is 'near'"},
      {"break",
       "test:1:6: the line ends; expected a place to stop: i123, clock N, primitive P, or a condition such as "
       "Z2[100,20] < 5000"},
      {"step 3 4", "test:1:8: unexpected text '4'; end the line before it, or start a comment with #"},
      {"print [20+:5][0,0]", "test:1:7: no such field; a pixel has 24 bits of memory, and a field has 1 to 32 bits"},
  }};
  for (const auto& [line, error] : lines) CHECK(debug.error(line) == error);
  CHECK(debug("   # a comment") == "");
  CHECK(debug("") == "");
}

TEST_CASE("the debugger accepts gdb's command names and abbreviations") {
  const std::array<std::pair<const char*, const char*>, 14> words{{{"n", "step"},
                                                                   {"next 2", "step 2"},
                                                                   {"s 3", "step 3"},
                                                                   {"stepi", "step"},
                                                                   {"ni 2", "step 2"},
                                                                   {"c", "run"},
                                                                   {"continue", "run"},
                                                                   {"u i5", "until i5"},
                                                                   {"p E", "print E"},
                                                                   {"l", "list"},
                                                                   {"bt", "where"},
                                                                   {"rs", "back"},
                                                                   {"b i5", "break i5"},
                                                                   {"h", "help"}}};
  for (const auto& each : words) {
    CAPTURE(each.first);
    Debugger one;
    Debugger other;
    CHECK(one(each.first) == other(each.second));
    CHECK(one("where") == other("where"));
  }
  Debugger debug;
  CHECK(debug.error("watch Z2[1,1]") ==
        "test:1:1: unknown command 'watch'; did you mean break change FIELD[x,y]? help lists the commands");
  CHECK(debug.error("stpe") == "test:1:1: unknown command 'stpe'; did you mean step? help lists the commands");
  CHECK(debug.error("break 5") ==
        "test:1:7: found '5'; expected a place to stop: i123, clock N, primitive P, or a condition such as "
        "Z2[100,20] < 5000");
}

TEST_CASE("the command back restores the state before the last executed instructions") {
  const isa::ArrayShape shape{9, 4, 40};
  CHECK(rc::check([&] {
    Debugger debug(*test::arbitrary_program(shape, 60, 2));
    std::vector<engine::RunState> states;
    while (!debug.session.run().is_finished()) {
      states.push_back(debug.session.run().save());
      debug("step");
    }
    const auto now = static_cast<std::int64_t>(states.size());
    std::int64_t at = now;
    for (int i = 0; i < 6; ++i) {
      const auto count = *rc::gen::inRange<std::int64_t>(1, 80);
      debug("back " + std::to_string(count));
      at = std::max<std::int64_t>(0, at - count);
      if (at == now || states.empty()) continue;
      const engine::RunState state = debug.session.run().save();
      // The pixels hold the state of the previous segment until the first instruction of a segment.
      RC_ASSERT(debug.session.number() ==
                engine::Numbers(debug.program).of(states[static_cast<std::size_t>(at)].place));
      if (state.place == states[static_cast<std::size_t>(at)].place)
        RC_ASSERT(state == states[static_cast<std::size_t>(at)]);
      const auto forth = *rc::gen::inRange<std::int64_t>(0, 3);
      for (std::int64_t step = 0; step < forth; ++step) debug("step");
      at = std::min(now, at + forth);
    }
  }));
}

TEST_CASE("instructions change only the bits that can_change() reports") {
  const isa::ArrayShape shape{6, 3, 24};
  const machines::Machine machine = planes(shape);
  CHECK(rc::check([&] {
    const isa::Program program = *test::arbitrary_program(shape, 40, 2);
    const auto run = engine::make_reference_engine(machine)->begin(program);
    const engine::Numbers numbers(program);
    while (!run->is_finished()) {
      const engine::RunState before = run->save();
      const bool has_next = before.place.index < program.segments[before.place.segment].instructions.size();
      run->advance(numbers.of(before.place) + 1, {});
      const engine::RunState after = run->save();
      if (!has_next || after.place.segment != before.place.segment) continue;
      const isa::Instruction& one = program.segments[before.place.segment].instructions[before.place.index];
      if (!debug::changes_enable(one.opcode)) RC_ASSERT(before.planes[0] == after.planes[0]);
      for (std::uint16_t bit = 0; bit < shape.memory_bits; ++bit)
        if (!debug::can_change(one, {bit, 1})) RC_ASSERT(before.planes[bit + 1U] == after.planes[bit + 1U]);
    }
  }));
}

TEST_CASE("the command until finds the same instructions as a check after every one") {
  const isa::ArrayShape shape{4, 2, 16};
  CHECK(rc::check([&] {
    Debugger debug(*test::arbitrary_program(shape, 60, 2));
    const debug::WatchedField watched{
        {0, static_cast<std::uint16_t>(*rc::gen::inRange(0, 3))}, *rc::gen::inRange(0U, 4U), *rc::gen::inRange(0U, 2U)};
    const debug::Condition condition{watched, debug::Relation::changes, 0};
    const auto run = engine::make_reference_engine(debug.machine)->begin(debug.program);
    const engine::Numbers numbers(debug.program);
    std::vector<std::uint64_t> expected;
    std::uint32_t value = 0;
    std::uint32_t segment = 0;
    while (!run->is_finished()) {
      run->advance(numbers.of(run->place()) + 1, {});
      if (!run->region().holds(watched.x, watched.y)) continue;
      const std::uint32_t before = run->place().segment == segment ? value : 0;
      segment = run->place().segment;
      value = debug::read_value(watched, *run);
      if (value != before) expected.push_back(numbers.of(run->place()));
    }
    std::vector<std::uint64_t> found;
    for (;;) {
      const std::string message = debug.session.execute(debug::Until{condition});
      if (message.find("was not reached") != std::string::npos) break;
      if (!debug.session.run().is_finished() || found.empty() || found.back() != debug.session.number())
        found.push_back(debug.session.number());
      if (debug.session.run().is_finished()) break;
    }
    RC_ASSERT(found == expected);
  }));
}

TEST_CASE("the debugger resumes from a checkpoint and rejects an invalid one") {
  const std::string file = (std::filesystem::temp_directory_path() / "csgsim_session_test.csgs").string();
  Debugger first;
  first("until i11");
  first("checkpoint " + file);
  Debugger second;
  CHECK(second("resume \"" + file + "\"") == "i11 of 18: copy Z2, Z1\n");
  CHECK(second.session.run().save() == first.session.run().save());
  CHECK(second("back") == "i10 of 18: field_lt Z1, Z2\n");
  std::ofstream(file) << "nothing";
  CHECK(second.error("resume " + file).find("does not begin with CSGS") != std::string::npos);
  CHECK(second.session.number() == 10);
  std::filesystem::remove(file);
}

TEST_CASE("the debugger's picture of a field is scaled from minimum to maximum") {
  Debugger debug;
  debug("until i12");
  const auto take = [&](const std::string& name) {
    const auto command =
        std::get<debug::TakePicture>(debug::parse_command("picture " + name + " f", "", 1, debug.program));
    return debug::draw_field(command.field, debug.session.run(), debug.program);
  };
  const debug::FieldPicture depth = take("Z2");  // 20 to 25, then 40 in columns 6 and 7
  CHECK(depth.scale == "black is 20, white 40 or nothing");
  CHECK(depth.picture.bytes ==
        std::vector<std::uint8_t>{0, 12, 25, 38, 51, 63, 255, 255, 0, 12, 25, 38, 51, 63, 255, 255});
  CHECK(take("E").picture.bytes[5] == 255);
  CHECK(take("E").picture.bytes[6] == 0);
  const debug::FieldPicture colour = take("colour");
  CHECK(colour.picture.channels == 3);
  CHECK(colour.picture.bytes[0] == 255);
  CHECK(colour.picture.bytes[3 * 3] == 0);  // colour 12 is green
  CHECK(colour.picture.bytes[3 * 3 + 1] == 255);
}

TEST_CASE("the debugger completes a word up to the common prefix of its candidates") {
  const std::array<std::string, 4> words{"back", "break", "breakpoints", "list"};
  CHECK(debug::complete("l", words).insert == "ist ");
  CHECK(debug::complete("print br", words).insert == "eak");
  CHECK(debug::complete("b", words).insert.empty());
  CHECK(debug::complete("b", words).candidates.size() == 3);
  CHECK(debug::complete("break", words).insert.empty());
  CHECK(debug::complete("x", words).candidates.empty());
}

TEST_CASE("a saved state of the debugger covers the instructions up to the next saved one") {
  debug::History history;
  CHECK(!history.has_recent_save(0));
  history.save_state(512, {});
  const std::uint64_t next = history.next_save_number(512);
  CHECK(next > 513);
  CHECK(!history.has_recent_save(511));
  CHECK(history.has_recent_save(512));
  CHECK(history.has_recent_save(next - 1));
  CHECK(!history.has_recent_save(next));
}

TEST_CASE("the debugger saves states at the start and at growing distances") {
  debug::History history;
  checkpoint::Snapshot snapshot;
  snapshot.picture.frame.colour.resize(1 << 20);
  std::uint64_t number = 0;
  for (; number < 200'000; number = history.next_save_number(number)) {
    if (history.has_recent_save(number)) continue;
    snapshot.run.overflows = number;
    history.save_state(number, snapshot);
  }
  CHECK(history.size() <= 32);
  CHECK(history.size() >= 8);
  CHECK(history.latest_at(0).run.overflows == 0);
  CHECK(history.latest_at(100'000).run.overflows <= 100'000);
  CHECK(history.latest_at(100'000).run.overflows > 80'000);
}

TEST_CASE("going back from between squares and their instruction discards the squares") {
  Debugger debug(
      R"(.array width=8 height=2 memory_bits=24
.field Z2 [0+:8] depth
.segment x=0 y=0 width=8 height=2
  enable_all
  edge_negative x - 3 (w8)
  enable_all
  squares 5*x*x (w12)
  edge_negative x - 3 (w12)
)");
  debug("step 2");
  CHECK(debug("print E") == "E = 1 at 6 of 16 pixels\n");
  debug("step 2");
  CHECK(debug("back 4") == "i0 of 5: enable_all\n");
  debug("step 2");
  CHECK(debug("print E") == "E = 1 at 6 of 16 pixels\n");
  debug("step 3");
  CHECK(debug("print E") == "E = 1 at 2 of 16 pixels\n");
}