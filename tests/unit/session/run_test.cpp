#include <unistd.h>

#include "hw/base/hash.h"
#include "hw/isa/binary.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/run_file.h"
#include "tests/support/test.h"
#include "tests/unit/session/parsed.h"

using namespace csgsim;

namespace {

/// A new folder that the destructor deletes.
struct Folder {
  fs::path path;

  explicit Folder(const std::string& name)
      : path(fs::temp_directory_path() / (name + "-" + std::to_string(::getpid()))) {
    fs::create_directory(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return path / name; }
};

/// Options of a run that writes and reads each kind of file.
session::ProgramRequest options_in(const Folder& folder) {
  session::ProgramRequest options;
  options.program = folder.file("frame.csgt");
  options.machine = folder.file("machine.toml");
  options.run.picture = folder.file("picture.png");
  options.run.depth = folder.file("depth.png");
  options.run.owner = folder.file("owner.png");
  options.run.stats = folder.file("stats.json");
  for (const std::string* const file : {&options.program, &options.machine, &options.run.picture, &options.run.depth,
                                        &options.run.owner, &options.run.stats})
    std::ofstream(*file) << "content";
  return options;
}

/// Returns the error message for a checkpoint; empty if it is allowed.
std::string refusal(session::ProgramRequest options, const std::string& checkpoint) {
  options.checkpoints.checkpoint = checkpoint;
  try {
    session::refuse_misuse(options);
  } catch (const session::UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a checkpoint must not replace any file that the run reads or writes") {
  const Folder folder("csgsim-calls");
  const session::ProgramRequest options = options_in(folder);
  for (const std::string& file : {options.program, options.machine, options.run.picture, options.run.depth,
                                  options.run.owner, options.run.stats}) {
    CAPTURE(file);
    CHECK(refusal(options, file).find(file) != std::string::npos);
    // A link to the file is recognized as well.
    const std::string link = file + ".link";
    fs::create_symlink(file, link);
    CHECK_FALSE(refusal(options, link).empty());
  }
  CHECK(refusal(options, folder.file("run.checkpoint")).empty());
}

TEST_CASE("a checkpoint may replace a file that the run does not name") {
  const Folder folder("csgsim-calls-free");
  session::ProgramRequest options = options_in(folder);
  for (std::string* const member : {&options.run.picture, &options.run.depth, &options.run.owner, &options.run.stats}) {
    const std::string file = *member;
    member->clear();
    CAPTURE(file);
    CHECK(refusal(options, file).empty());
    *member = file;
  }
}

TEST_CASE("a run may overwrite the checkpoint from which it resumes") {
  const Folder folder("csgsim-calls-resume");
  session::ProgramRequest options = options_in(folder);
  options.checkpoints.resume = folder.file("run.checkpoint");
  std::ofstream(options.checkpoints.resume) << "content";
  CHECK(refusal(options, options.checkpoints.resume).empty());
}

TEST_CASE("the inputs of a run are its Program and machine file and resumed checkpoint") {
  session::ProgramRequest options;
  options.program = "a.csgt";
  CHECK(options.files_read() == std::vector<fs::path>{"a.csgt"});
  options.machine = "b.toml";
  options.checkpoints.resume = "c.checkpoint";
  CHECK(options.inputs() == std::vector<fs::path>{"a.csgt", "b.toml"});
  CHECK(options.files_read() == std::vector<fs::path>{"a.csgt", "b.toml", "c.checkpoint"});
  options.machine = "pixel-planes-4";  // a name is not a file
  CHECK(options.inputs() == std::vector<fs::path>{"a.csgt"});
}

namespace {

/// A box as a Program for pixel-planes-4.
isa::Program small_program() {
  const std::vector<std::string> words{"box.csg", "--size", "16x12", "--camera", "0,-50,0,0,0,0"};
  const session::ModelRequest options = session::parse_model_request(words);
  const machines::Machine machine = session::machine_of(options);
  return session::compile_model(session::read_model_file(options, "cube(size=[8,6,4],center=true);"),
                                session::choices_of(options, machine), machine)
      .program;
}

/// Hash of all bytes of a file, read independently.
std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  Hash hash;
  hash.add(bytes);
  return hash.text();
}

}  // namespace

TEST_CASE("run takes a Program and machine parameters and run and checkpoint options") {
  using session::ProgramRequest;
  const testing::Parsed<ProgramRequest> all({"a.csgt", "--machine", "pixel-planes-4", "--set", "alu.bits=2", "--stats",
                                             "s.json", "--resume", "c.checkpoint"});
  CHECK(all.options.program == "a.csgt");
  CHECK(all.options.machine == "pixel-planes-4");
  CHECK(all.options.sets == std::vector<std::string>{"alu.bits=2"});
  CHECK(all.options.run.stats == "s.json");
  CHECK(all.options.checkpoints.resume == "c.checkpoint");
  CHECK(testing::option_error<ProgramRequest>({}) != "");
  CHECK(testing::option_error<ProgramRequest>({"a.csgt", "--machine", "pixel-plane-4"}) != "");
}

TEST_CASE("--set for a Program accepts machine parameters but no scene keys") {
  session::ProgramRequest options;
  options.program = "a.csgt";
  options.sets = {"alu.bits=4"};
  CHECK(testing::usage_error_of([&] { session::refuse_misuse(options); }) == "");
  options.sets = {"effects.depth_cue.on=true"};
  CHECK(testing::usage_error_of([&] { session::refuse_misuse(options); }) != "");
}

TEST_CASE("a Program in memory runs like its file and has the file's hash") {
  const Folder folder("csgsim-calls-load");
  const isa::Program program = small_program();
  session::ProgramRequest options;
  options.program = folder.file("p.csgt");
  const std::vector<std::byte> bytes = isa::encode(program);
  std::ofstream(options.program, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const session::LoadedProgram of_file = session::load(options);
  CHECK(of_file.hash.empty());
  CHECK_FALSE(of_file.is_in_place);
  CHECK_FALSE(of_file.subject().is_in_place);
  CHECK(of_file.inputs == std::vector<fs::path>{options.program});
  const session::LoadedProgram in_place = session::load(options, {.text = {}, .program = &program});
  CHECK(in_place.hash == hash_of_file(options.program));
  CHECK(in_place.is_in_place);
  CHECK(in_place.subject().is_in_place);
  CHECK(in_place.subject().hash == in_place.hash);
  CHECK(in_place.inputs == of_file.inputs);
  CHECK(isa::encode(in_place.program) == bytes);
  CHECK(isa::encode(of_file.program) == bytes);
  for (const session::LoadedProgram* const loaded : {&of_file, &in_place}) {
    CHECK(loaded->machine.picture.width == 16);
    CHECK(loaded->machine.picture.height == 12);
    CHECK(&loaded->subject().program == &loaded->program);
    CHECK(&loaded->subject().machine == &loaded->machine);
  }
  // The requested machine and the figures set for it.
  options.machine = "pixel-planes-4";
  options.sets = {"clock.frequency=5000000"};
  CHECK(session::load(options).machine.clock_hz == 5'000'000);
  CHECK(of_file.machine.clock_hz == 10'000'000);
  fs::remove(options.program);
  CHECK(session::load(options, {.text = {}, .program = &program}).machine.clock_hz == 5'000'000);
}

TEST_CASE("advice on a Program is for the requested machine or for the Program's own") {
  session::ProgramRequest options;
  machines::Machine machine;
  machine.name = "its own";
  CHECK(session::advice_of(options, machine).machine == "its own");
  CHECK_FALSE(session::advice_of(options, machine).is_asked);
  CHECK_FALSE(session::advice_of(options, machine).settings);
  options.machine = "another";
  options.run.advice = true;
  CHECK(session::advice_of(options, machine).machine == "another");
  CHECK(session::advice_of(options, machine).is_asked);
  CHECK(session::advice_of(options, machine).ask.starts_with("--advice tries machine parameters; "));
}
