#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

using Words = std::vector<std::string>;

const std::string two_cubes =
    "difference() { cube(size = [8, 6, 4], center = true); multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,2],[0,0,0,1]]) { "
    "sphere(r = 2, $fn = 8); } }\n";

Words study(const std::string& command) {
  if (command == "sweep") return {"sweep", "a.csg", "b.csg", "--size=24x20", "--z-bits", "16,20", "--threads", "2"};
  if (command == "accuracy")
    return {"accuracy", "a.csg", "--size", "8x8", "--views", "1", "--pruning", "no-hidden+no-near"};
  return {"compare", "a.csg", "--camera", "-20,-30,25,0,0,0", "--sides", "16,24", "--fragments", "5,8"};
}

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words shard(unsigned number, unsigned count) {
  return {"--shard", std::to_string(number) + "/" + std::to_string(count)};
}

void write_models(const Folder& folder) {
  write(folder / "a.csg", two_cubes);
  write(folder / "b.csg", two_cubes + two_cubes);
}

/// All files in a study's folder except its shards, by name.
std::map<std::string, std::string> results(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != "shards") files[entry.path().filename()] = content(entry.path());
  return files;
}

Words shard_files(const std::string& folder) {
  Words files;
  for (const auto& entry : fs::directory_iterator(folder + "/shards")) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Where the rows of a shard's file begin, after the study, the command and the columns.
std::size_t begin_of_rows(const std::string& text) {
  std::size_t at = 0;
  for (int line = 0; line < 3; ++line) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) return text.size();
    at = end + 1;
  }
  return at;
}

std::size_t rows_in(const std::string& file) {
  const std::string text = content(file);
  return static_cast<std::size_t>(
      std::count(text.begin() + static_cast<std::ptrdiff_t>(begin_of_rows(text)), text.end(), '\n'));
}

std::size_t rows(const std::string& folder) {
  std::size_t sum = 0;
  for (const std::string& file : shard_files(folder)) sum += rows_in(file);
  return sum;
}

/// Starts csgsim as a concurrent process.
pid_t start(const Words& words, const fs::path& where) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child > 0) return child;
  const Outcome outcome = run_words(words, where);
  std::_Exit(outcome.code);
}

int code_of(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void run_shards(const Words& words, unsigned count, const fs::path& where) {
  for (unsigned number = 1; number <= count; ++number) {
    const Outcome outcome = require_success(run_words(words + shard(number, count), where));
    CHECK(outcome.err.empty());
  }
}

void refuses_to_gather(const Words& words, const fs::path& where, const Words& texts) {
  const Outcome outcome = run_words(Words{"gather"} + words, where);
  fails(outcome, 1, texts);
  CHECK(outcome.out.empty());
}

}  // namespace

TEST_CASE("gather without the models equals a run of one process") {
  for (const std::string command : {"sweep", "accuracy", "compare"}) {
    CAPTURE(command);
    const Folder folder;
    write_models(folder);
    const Outcome one = require_success(run_words(study(command) + Words{"--no-plots", "-o", "out"}, folder.path()));
    const std::map<std::string, std::string> wanted = results(folder / "out");
    REQUIRE(wanted.size() == 3);
    for (const unsigned count : {1U, 2U, 3U, 7U}) {
      CAPTURE(count);
      fs::remove_all(folder / "out");
      write_models(folder);
      run_shards(study(command) + Words{"-o", "out"}, count, folder.path());
      CHECK(results(folder / "out").empty());
      fs::remove(folder / "a.csg");
      fs::remove(folder / "b.csg");
      const Outcome gathered = require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
      CHECK(gathered.err.empty());
      CHECK(gathered.out == one.out);
      CHECK(results(folder / "out") == wanted);
      // Repeats it over the existing files.
      require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
      CHECK(results(folder / "out") == wanted);
    }
  }
}

TEST_CASE("plots of gathered shards equal those of one process") {
  for (const std::string command : {"sweep", "compare"}) {
    CAPTURE(command);
    const Folder folder;
    write_models(folder);
    require_success(run_words(study(command) + Words{"-o", "one"}, folder.path()));
    run_shards(study(command) + Words{"-o", "out"}, 2, folder.path());
    require_success(run_words({"gather", "out"}, folder.path()));
    CHECK(results(folder / "one").size() > 4);
    CHECK(results(folder / "out") == results(folder / "one"));
  }
}

TEST_CASE("gather merges shards from several folders into one that the study can continue") {
  const Folder folder;
  write_models(folder);
  const Words sweep = study("sweep") + Words{"--no-plots"};
  require_success(run_words(sweep + Words{"-o", "one"}, folder.path()));
  require_success(run_words(sweep + Words{"-o", "here"} + shard(1, 2), folder.path()));
  require_success(run_words(sweep + Words{"-o", "there"} + shard(2, 2), folder.path()));
  refuses_to_gather({"here", "--no-plots"}, folder.path(),
                    {"shard 2 of 2 is not complete; complete it by: csgsim sweep --shard 2/2 -o here a.csg b.csg"});
  CHECK(run_words({"gather", "here", "there"}, folder.path()).code == 2);
  require_success(run_words({"gather", "here", "there", "-o", "out", "--no-plots"}, folder.path()));
  CHECK(results(folder / "out") == results(folder / "one"));
  // A single process finds all points in its table.
  require_success(run_words(sweep + Words{"-o", "out"}, folder.path()));
  CHECK(results(folder / "out") == results(folder / "one"));
}

TEST_CASE("gather names each missing shard with the command that measures it") {
  const Folder folder;
  write_models(folder);
  const Words sweep = study("sweep") + Words{"-o", "out"};
  require_success(run_words(sweep + Words{"--no-plots"}, folder.path()));
  const std::map<std::string, std::string> wanted = results(folder / "out");
  fs::remove_all(folder / "out");
  for (const unsigned number : {2U, 5U}) REQUIRE(run_words(sweep + shard(number, 6), folder.path()).code == 0);
  refuses_to_gather(
      {"out"}, folder.path(),
      {"out: ", "shards 1,3-4,6 of 6 are not complete; print the command of each by: csgsim gather --missing out\n"});
  const Outcome missing = require_success(run_words({"gather", "out", "--missing"}, folder.path()));
  std::istringstream commands(missing.out);
  std::size_t count = 0;
  for (std::string command; std::getline(commands, command); ++count) {
    REQUIRE(command.starts_with("csgsim "));
    CHECK(command.find(" --threads 2") != std::string::npos);
    const Outcome outcome =
        run_program("/bin/sh", {"-c", std::string(CSGSIM_BINARY_DIR) + "/" + command}, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
  }
  CHECK(count == 4);
  CHECK(run_words({"gather", "out", "--missing"}, folder.path()).out.empty());
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  CHECK(results(folder / "out") == wanted);
}

TEST_CASE("the printed command of a shard has all options of the shard, and is checked") {
  const Folder folder;
  write_models(folder);
  const Words sweep{"sweep", "a.csg", "--size", "24x20", "--strategy", "stack,list"};
  require_success(run_words(
      sweep + Words{"--threads", "3", "--progress", "none", "--no-plots", "-o", "out"} + shard(1, 2), folder.path()));
  const std::string command = require_success(run_words({"gather", "out", "--missing"}, folder.path())).out;
  CHECK(command.starts_with("csgsim sweep --shard 2/2 -o out a.csg "));
  for (const std::string option : {"--threads 3", "--progress none", "--no-plots", "--size 24x20"}) {
    CAPTURE(option);
    CHECK(command.find(" " + option) != std::string::npos);
  }
  // Shards that differ only in such options are of one study.
  require_success(run_words(sweep + Words{"--threads", "1", "-o", "out"} + shard(2, 2), folder.path()));
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  // A shard's file is untrusted: its command may name no output and no other study.
  const std::string file = shard_files(folder / "out").front();
  const std::string text = content(file);
  const std::size_t options = text.find("# command,sweep,a.csg,");
  REQUIRE(options != std::string::npos);
  for (const std::string more : {"--report,x.html,", "--output,elsewhere,", "--z-bits,12,", "--nothing,1,"}) {
    CAPTURE(more);
    std::string changed = text;
    write(file, changed.insert(options + 22, more));
    refuses_to_gather({"out", "--missing"}, folder.path(), {".shard:1:1: the command is not one of a shard"});
  }
  // A file of an earlier version has only the words that affect results.
  const std::size_t end = text.find('\n', options) + 1;
  write(file, text.substr(0, options) + text.substr(end));
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
}

TEST_CASE("the printed command of a shard is quoted so that a shell repeats its arguments") {
  const Folder folder;
  const std::string name = "- it's,\"odd\" \xff.csg";
  write(folder / name, two_cubes);
  const Words compare{"compare",     "--camera=-20,-30,25,0,0,0",
                      "--sides",     "",
                      "--fragments", "5",
                      "--pruning",   "no-near",
                      "--set",       "background.colour=1,0,0",
                      "--set",       "lights.0.direction=0,0,-1",
                      "--machines",  "scan-line"};
  const Words operand{"--", name};
  require_success(run_words(compare + Words{"-o", "one", "--no-plots"} + operand, folder.path()));
  require_success(run_words(compare + Words{"-o", "out"} + shard(1, 2) + operand, folder.path()));
  const Outcome missing = run_words({"gather", "out", "--missing"}, folder.path());
  REQUIRE(missing.out.starts_with("csgsim compare --shard 2/2 -o out "));
  // $'...' is an extension of the POSIX shell.
  const Outcome other =
      run_program("/bin/bash", {"-c", std::string(CSGSIM_BINARY_DIR) + "/" + missing.out}, folder.path());
  CAPTURE(other.err);
  REQUIRE(other.code == 0);
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  CHECK(results(folder / "out") == results(folder / "one"));
}

TEST_CASE("gather rejects shards of several studies and duplicates of a shard") {
  const Folder folder;
  write_models(folder);
  const Words accuracy = study("accuracy");
  run_shards(accuracy + Words{"-o", "out"}, 2, folder.path());
  const Words whole = shard_files(folder / "out");
  REQUIRE(whole.size() == 2);
  const auto add_shard = [&](const Words& words, const std::string& name) {
    fs::remove_all(folder / "other");
    require_success(run_words(words + Words{"-o", "other"}, folder.path()));
    fs::copy_file(shard_files(folder / "other").front(), folder / ("out/shards/" + name));
  };
  const auto refused = [&](const Words& texts) {
    refuses_to_gather({"out", "--no-plots"}, folder.path(), texts);
    for (const std::string& file : shard_files(folder / "out"))
      if (std::ranges::find(whole, file) == whole.end()) fs::remove(file);
    CHECK(results(folder / "out").empty());
  };

  add_shard(accuracy + shard(3, 4), "x.csv");
  refused({"shard 3/4", "shard 1/2", "of 4 and of 2 shards"});
  add_shard(accuracy + Words{"--z-bits", "16"} + shard(1, 2), "x.csv");
  refused({"of different commands", "--z-bits 16", "one study at a time"});
  add_shard(study("sweep") + shard(1, 2), "x.csv");
  refused({"of different commands"});
  write(folder / "a.csg", two_cubes + two_cubes);
  add_shard(accuracy + shard(2, 2), "x.csv");
  refused({"the model changed between them", "x.csv"});
  write_models(folder);

  // A shard of another build of csgsim.
  std::string older = content(whole[1]);
  const std::size_t version = older.find(",0.1.0 ");
  REQUIRE(version < older.find('\n'));
  write(folder / "out/shards/x.csv", older.replace(version, 7, ",0.0.9 "));
  refused({"csgsim changed between them"});

  // Points measured by two processes of one shard must be equal.
  fs::copy_file(whole[1], folder / "out/shards/x.csv");
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  for (const char* const ending : {"csv", "study", "json"})
    fs::remove(folder / ("out/accuracy." + std::string(ending)));
  std::string wrong = content(whole[1]);
  wrong.replace(wrong.rfind(',') + 1, 1, "7");
  write(folder / "out/shards/x.csv", wrong);
  refused({"different results for point"});

  // Each shard may exist in only one place.
  fs::copy(folder / "out", folder / "copy", fs::copy_options::recursive);
  refuses_to_gather({"out", "copy", "-o", "both"}, folder.path(), {"shard 1/2 is in out and in copy", "omit one"});

  // A shard holds no points of another shard.
  const std::string other = content(whole[0]);
  const std::size_t row = begin_of_rows(other);
  write(folder / "out/shards/x.csv", content(whole[1]) + other.substr(row, other.find('\n', row) + 1 - row));
  refused({"belongs to shard 1/2", "x.csv"});
  write(folder / "out/shards/x.csv", "knob,value\n");
  refused({"x.csv:1:1: this is not a shard"});
  refuses_to_gather({"nowhere"}, folder.path(), {"nowhere: contains no shards of a study"});
}

TEST_CASE("gather does not overwrite points that the shards lack") {
  const Folder folder;
  write_models(folder);
  const Words sweep{"sweep", "a.csg", "--size", "24x20", "--no-plots", "-o", "out", "--strategy"};
  require_success(run_words(sweep + Words{"parallel"}, folder.path()));
  const std::string before = content(folder / "out/sweep.csv");
  require_success(run_words(sweep + Words{"stack,list"} + shard(1, 1), folder.path()));
  refuses_to_gather({"out"}, folder.path(), {"sweep.csv: has points that the shards lack", "-o"});
  CHECK(content(folder / "out/sweep.csv") == before);
}

TEST_CASE("a shard is measured again after its model changed") {
  const Folder folder;
  write_models(folder);
  const Words sweep = study("sweep") + Words{"-o", "out"};
  run_shards(sweep, 2, folder.path());
  write(folder / "a.csg", two_cubes + two_cubes);
  for (const unsigned number : {1U, 2U}) {
    const Outcome outcome = require_success(run_words(sweep + shard(number, 2), folder.path()));
    CHECK(is_one_line(outcome.err));
    CHECK(outcome.err.find("the model has changed") != std::string::npos);
  }
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  require_success(run_words(study("sweep") + Words{"-o", "one", "--no-plots"}, folder.path()));
  CHECK(results(folder / "out") == results(folder / "one"));
  fails(run_words(sweep + Words{"--no-draw"} + shard(1, 2), folder.path()), 1,
        {"holds a shard of another study, sweep a.csg b.csg"});
}

TEST_CASE("a killed shard resumes and measures no point twice") {
  const Folder folder;
  const Words sweep{"sweep", model("carburettor"), "--size", "300x300",    "--strategy", "bits", "--stack-bits",
                    "3..14", "--threads",          "1",      "--no-plots", "-o",         "out"};
  const fs::path where = folder.path();
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    REQUIRE(::chdir(where.c_str()) == 0);
    Words all = Words{std::string(CSGSIM_BINARY_DIR) + "/csgsim"} + sweep + shard(1, 1);
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(arguments.front(), arguments.data());
    std::_Exit(127);
  }
  const auto measured = [&] { return fs::exists(folder / "out/shards") ? rows(folder / "out") : 0; };
  for (int wait = 0; wait < 6000 && measured() < 3; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, SIGKILL);
  CHECK(code_of(child) == -1);
  const Words left = shard_files(folder / "out");
  REQUIRE(left.size() == 1);
  CHECK(rows_in(left.front()) >= 3);
  CHECK(rows_in(left.front()) < 12);
  // Leaves half a line, as after a power failure.
  std::string text = content(left.front());
  write(left.front(), text + text.substr(text.rfind('\n', text.size() - 2) + 1, 30));
  require_success(run_words(sweep + shard(1, 1), where));
  CHECK(shard_files(folder / "out").size() == 2);
  CHECK(rows(folder / "out") == 12);
  require_success(run_words({"gather", "out", "--no-plots"}, where));
  require_success(run_words(Words(sweep.begin(), sweep.end() - 1) + Words{"one"}, where));
  CHECK(results(folder / "out") == results(folder / "one"));
}

TEST_CASE("a shard that runs in several processes at once gives the results of one") {
  const Folder folder;
  write_models(folder);
  const Words sweep = study("sweep") + Words{"-o", "out"};
  require_success(run_words(study("sweep") + Words{"-o", "one", "--no-plots"}, folder.path()));
  std::vector<pid_t> processes;
  for (int i = 0; i < 4; ++i) processes.push_back(start(sweep + shard(1, 1), folder.path()));
  for (const pid_t process : processes) CHECK(code_of(process) == 0);
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
  CHECK(results(folder / "out") == results(folder / "one"));
}

TEST_CASE("a shard without points writes nothing and gather succeeds without it") {
  const Folder folder;
  write_models(folder);
  const Words sweep{"sweep", "a.csg", "--size", "24x20", "--strategy", "stack", "-o", "out"};
  std::size_t empty = 0;
  for (const unsigned number : {1U, 2U}) {
    const Outcome outcome = require_success(run_words(sweep + shard(number, 2), folder.path()));
    if (outcome.out.find(": 0 of the 1 points") != std::string::npos) ++empty;
  }
  CHECK(empty == 1);
  require_success(run_words({"gather", "out", "--no-plots"}, folder.path()));
}

TEST_CASE("gather reports a point that does not fit as a single process does") {
  const Folder folder;
  write_models(folder);
  const Words sweep{"sweep", "a.csg", "--size", "24x20", "--memory-bits", "30", "-o", "out", "--no-plots"};
  const Outcome one = run_words(sweep, folder.path());
  CHECK(one.code == 1);
  fs::remove_all(folder / "out");
  run_shards(sweep, 2, folder.path());
  const Outcome gathered = run_words({"gather", "out", "--no-plots"}, folder.path());
  CHECK(gathered.code == 1);
  CHECK(gathered.err == one.err);
  CHECK(gathered.out == one.out);
}

TEST_CASE("rejects an unknown shard number and suggests a valid one") {
  const Folder folder;
  for (const std::string command : {"sweep", "accuracy", "compare"}) {
    const std::string words = command + " " + model("old_example011") + " -o " + (folder / "s") + " --shard ";
    check_misuse(words + "0/4", "shard 0 of 4 does not exist; choose one of 1/4 to 4/4");
    check_misuse(words + "5/4", "shard 5 of 4 does not exist; choose one of 1/4 to 4/4");
    check_misuse(words + "a/b", "'a/b' is not a shard; use k/n, such as 3/16");
    check_misuse(words + "3", "use k/n");
    check_misuse(words + "1/0", "the number of shards must be from 1 to");
    check_misuse(words + "-1/4", "use k/n");
    check_misuse(words + "1/2/3", "use k/n");
  }
  check_misuse("gather", "FOLDER");
  CHECK(folder.files() == 0);
}

TEST_CASE("the scripts in docs/cluster run the shard assigned by their launcher") {
  const Folder folder;
  write_models(folder);
  const std::string scripts = std::string(CSGSIM_SOURCE_DIR) + "/docs/cluster/";
  const std::string path = "PATH=" + std::string(CSGSIM_BINARY_DIR) + ":$PATH ";
  const std::string words = " sweep a.csg --size 24x20 -o out";
  const auto runs = [&](const std::string& command) {
    fs::remove_all(folder / "out");
    return run_program(
        "/bin/sh", {"-c", "unset OMPI_COMM_WORLD_RANK PMI_RANK SLURM_PROCID SLURM_ARRAY_TASK_ID; " + path + command},
        folder.path());
  };
  CHECK(runs("SLURM_ARRAY_TASK_ID=3 SLURM_ARRAY_TASK_COUNT=2 " + scripts + "array.sh 4" + words)
            .out.starts_with("shard 3/4: "));
  CHECK(runs("OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=5 " + scripts + "rank.sh" + words)
            .out.starts_with("shard 1/5: "));
  CHECK(runs("PMI_RANK=4 PMI_SIZE=5 " + scripts + "rank.sh" + words).out.starts_with("shard 5/5: "));
  CHECK(runs("SLURM_PROCID=1 SLURM_STEP_NUM_TASKS=2 " + scripts + "rank.sh" + words).out.starts_with("shard 2/2: "));
  // A batch script without srun has SLURM_PROCID set to 0.
  fails(runs("SLURM_PROCID=0 " + scripts + "rank.sh" + words), 2, {"start it with mpirun or srun"});
  // Without a launcher, and without arguments, each script says how to start it.
  for (const std::string& arguments : {" 4" + words, std::string()}) {
    const Outcome alone = runs(scripts + "array.sh" + arguments);
    CHECK(alone.code == 2);
    CHECK(alone.err.find("sbatch --array=1-16 array.sh 16 sweep model.csg -o out") != std::string::npos);
  }
  CHECK(runs("SLURM_ARRAY_TASK_ID=3 " + scripts + "array.sh" + words).err.find("'sweep' is not a number of shards") !=
        std::string::npos);
  CHECK(runs(scripts + "rank.sh").err.find("usage: ") != std::string::npos);
}
