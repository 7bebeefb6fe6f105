#include "sim/session/run/frames.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string_view>

#include "host/view/camera.h"
#include "hw/host/host.h"
#include "hw/isa/facts.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "sim/session/model/cameras.h"
#include "sim/session/model/frame_compiler.h"
#include "sim/session/run/frame_pictures.h"
#include "tests/support/error_of.h"
#include "tests/support/test.h"
#include "tests/unit/session/parsed.h"

using namespace csgsim;
using session::FramesRequest;
using testing::Parsed;

namespace {

session::ModelRequest request_of(const std::string& model, const std::string& machine, const std::string& size) {
  session::ModelRequest request;
  request.model = std::string(CSGSIM_SOURCE_DIR "/tests/models/") + model + ".csg";
  request.machine = machine;
  request.size = size;
  request.memory_bits = session::ample_memory_bits;
  return request;
}

/// Four cameras around the model: some turned, one nearer, one from below.
std::vector<view::Camera> path_around(const view::Camera& first) {
  view::Camera near = view::turned(first, 2.5);
  near.eye = near.centre + 0.7 * (near.eye - near.centre);
  view::Camera low = view::turned(first, 4);
  low.eye.z = 2 * low.centre.z - low.eye.z;
  return {first, view::turned(first, 0.1), near, low};
}

/// The Program without the counts of host work.
isa::Program without_host_work(isa::Program program) {
  *program.preparation = {};
  *program.model_preparation = {};
  program.facts->prunings.clear();
  for (isa::Segment& segment : program.segments) *segment.preparation = {};
  return program;
}

isa::Preparation host_work(const isa::Program& program) {
  isa::Preparation all = *program.preparation;
  for (const isa::Segment& segment : program.segments) all += *segment.preparation;
  return all;
}

/// The Program of one frame, compiled without results of other frames.
isa::Program compiled_alone(const session::ModelRequest& request, const machines::Machine& machine,
                            const view::Camera& camera) {
  setup::Choices choices = session::choices_of(request, machine);
  choices.camera = {.given = camera, .projection = camera.projection};
  return session::compile_model(session::read_model_file(request), std::move(choices), machine).program;
}

/// Checks that each frame of a path has the instructions of a separately compiled Program.
void check_frames(const session::ModelRequest& request) {
  const machines::Machine machine = session::machine_of(request);
  session::FrameCompiler compiler(request, machine);
  for (const view::Camera& camera : path_around(compiler.model().camera))
    CHECK(without_host_work(compiler.compile(camera)) == without_host_work(compiled_alone(request, machine, camera)));
}

/// Writes a file of cameras; it is removed afterwards.
class CameraFile {
 public:
  explicit CameraFile(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / ("cameras-" + std::to_string(::getpid()) + ".txt")).string()) {
    std::ofstream(path_) << text;
  }
  ~CameraFile() { std::filesystem::remove(path_); }
  CameraFile(const CameraFile&) = delete;
  CameraFile& operator=(const CameraFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The message about a file of cameras, without its name; empty if it is accepted.
std::string fault_in(const std::string& text, std::size_t most = 3) {
  const CameraFile file(text);
  const std::string error = testing::error_of([&] { session::read_cameras(file.path(), most); });
  return error.empty() ? error : error.substr(file.path().size() + 1);
}

}  // namespace

TEST_CASE("each frame has the instructions of a separately compiled Program") {
  for (const std::string_view name : kinds::built_in_names()) {
    for (const std::string model : {"thesis_fig_2_3", "basics_csg", "old_example002"}) {
      CAPTURE(name);
      CAPTURE(model);
      check_frames(request_of(model, std::string(name), "64x64"));
    }
  }
}

TEST_CASE("each frame equals a separately compiled Program with any prunings") {
  for (const std::string pruning : {"auto", "all", "none", "no-separation", "no-halfspaces", "no-sets", "halfspaces"}) {
    for (const std::string machine_name : {"pixel-planes-4", "scan-line", "pixel-planes-4+host.processor=i486dx2"}) {
      CAPTURE(pruning);
      CAPTURE(machine_name);
      session::ModelRequest request = request_of("rietveld_house", machine_name, "48x40");
      request.pruning = pruning;
      check_frames(request);
    }
  }
}

TEST_CASE("each frame equals a separately compiled Program with any strategy") {
  for (const std::string strategy : {"products", "bits", "auto"}) {
    for (const std::string pruning : {"auto", "all"}) {
      CAPTURE(strategy);
      CAPTURE(pruning);
      session::ModelRequest request = request_of("old_example002", "pixel-planes-4", "48x40");
      request.strategy = strategy;
      request.pruning = pruning;
      check_frames(request);
    }
  }
}

TEST_CASE("a repeated frame finds all active trees and counts less host work") {
  const session::ModelRequest request = request_of("thesis_fig_2_3", "scan-line", "64x64");
  const machines::Machine machine = session::machine_of(request);
  session::FrameCompiler compiler(request, machine);
  const view::Camera camera = compiler.model().camera;
  const isa::Program alone = compiled_alone(request, machine, camera);
  const isa::Program first = compiler.compile(camera);
  const csg::ReuseCounts in_first = compiler.reused();
  CHECK(in_first.trees < in_first.lookups);
  CHECK(in_first.trees > 0);  // trees of lines above are reused
  const isa::Program second = compiler.compile(camera);
  const csg::ReuseCounts in_second = compiler.reused();
  CHECK(in_second.trees == in_second.lookups);
  CHECK(in_second.certificates >= in_first.certificates);
  const isa::Preparation work = host_work(second);
  const isa::Preparation work_alone = host_work(alone);
  CHECK(work.nodes < work_alone.nodes);
  CHECK(work.halfspaces <= work_alone.halfspaces);
  CHECK(work.halfspaces <= host_work(first).halfspaces);
  CHECK(work.planes == work_alone.planes);
  CHECK(work.supports == work_alone.supports);
}

TEST_CASE("frames after the first count no more host work than frames alone") {
  for (const std::string machine_name : {"pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5"}) {
    CAPTURE(machine_name);
    const session::ModelRequest request = request_of("rietveld_house", machine_name, "64x64");
    const machines::Machine machine = session::machine_of(request);
    session::FrameCompiler compiler(request, machine);
    static_cast<void>(compiler.compile(compiler.model().camera));
    for (int step = 1; step < 4; ++step) {
      const view::Camera camera = view::turned(compiler.model().camera, 0.1 * step);
      const isa::Program program = compiler.compile(camera);
      const isa::Program alone = compiled_alone(request, machine, camera);
      CHECK(host::compile_clocks(program, machine) <= host::compile_clocks(alone, machine));
    }
  }
}

TEST_CASE("a sequence of frames does the work for the model once") {
  for (const std::string machine_name : {"pixel-planes-4", "pixel-square"}) {
    CAPTURE(machine_name);
    session::ModelRequest request = request_of("rietveld_house", machine_name, "64x64");
    request.pruning = machine_name == "pixel-square" ? "auto" : "all";
    const machines::Machine machine = session::machine_of(request);
    session::FrameCompiler compiler(request, machine);
    const view::Camera camera = compiler.model().camera;
    const isa::Preparation alone = *compiled_alone(request, machine, camera).model_preparation;
    CHECK(alone.nodes > 0);
    CHECK(*compiler.compile(camera).model_preparation == alone);
    CHECK(*compiler.compile(camera).model_preparation == isa::Preparation{});
    // Another camera needs planes between other pairs only.
    const isa::Preparation other = *compiler.compile(view::turned(camera, 2)).model_preparation;
    CHECK(other.nodes == 0);
    CHECK(other.supports <= compiled_alone(request, machine, view::turned(camera, 2)).model_preparation->supports);
    CHECK(*compiler.compile(camera).model_preparation == isa::Preparation{});
  }
}

TEST_CASE("the work for the model is repeated when the camera changes the model's facets") {
  session::ModelRequest request = request_of("basics_csg", "pixel-planes-4", "64x64");
  request.tolerance = setup::Tolerance{0.5, true};
  const machines::Machine machine = session::machine_of(request);
  session::FrameCompiler compiler(request, machine);
  std::vector<view::Camera> path = path_around(compiler.model().camera);
  path.pop_back();
  for (const view::Camera& camera : path) {
    const isa::Program program = compiler.compile(camera);
    const isa::Program alone = compiled_alone(request, machine, camera);
    CHECK(without_host_work(program) == without_host_work(alone));
    CHECK((program.model_preparation->nodes == 0 || *program.model_preparation == *alone.model_preparation));
  }
  CHECK(compiler.compile(path[0]).model_preparation->nodes > 0);  // the last camera was nearer and had other facets
}

TEST_CASE("reads one camera per line and ignores comments and blank lines") {
  const CameraFile file("# a path\n\n 1,2,3,4,5,6  # first\r\n\t0,0,5,70,30,210,100\n7,8,9,0,0,0");
  const std::vector<view::Camera> cameras = session::read_cameras(file.path(), 3);
  REQUIRE(cameras.size() == 3);
  CHECK(cameras[0].eye == glm::dvec3(1, 2, 3));
  CHECK(cameras[0].centre == glm::dvec3(4, 5, 6));
  CHECK(cameras[1].eye == view::gimbal_camera({0, 0, 5}, {70, 30, 210}, 100).eye);
  CHECK(cameras[1].up == view::gimbal_camera({0, 0, 5}, {70, 30, 210}, 100).up);
  CHECK(cameras[2].eye == glm::dvec3(7, 8, 9));
}

TEST_CASE("rejects faults in a file of cameras with their line and column") {
  const std::string form = "' is not of the form ex,ey,ez,cx,cy,cz or x,y,z,rx,ry,rz,d";
  CHECK(fault_in("1,2,3,4,5,6\n  1,2,x,4,5,6\n") == "2:7: '1,2,x,4,5,6" + form);
  CHECK(fault_in("1,2,3,4,5\n") == "1:1: '1,2,3,4,5" + form);
  CHECK(fault_in("1,2,3,4,5,\n") == "1:11: '1,2,3,4,5," + form);
  CHECK(fault_in("\n1,2,3,4,5,6,-7\n") == "2:13: the distance (last number) must be above 0");
  CHECK(fault_in("1,2,3,1,2,3").find("1:1: the camera's eye and centre must be different") == 0);
  CHECK(fault_in("# nothing\n") == " no camera; write one per line, as for --camera");
  CHECK(fault_in("0,0,1,0,0,0\n0,0,2,0,0,0\n", 1) == "2:1: more than 1 cameras; split the file into several");
}

TEST_CASE("frames are numbered at a placeholder or after the name and share one .gif") {
  using Paths = std::vector<std::filesystem::path>;
  CHECK(session::frame_paths("", 2).empty());
  CHECK(session::frame_paths("a/f.png", 2) == Paths{"a/f_000.png", "a/f_001.png"});
  CHECK(session::frame_paths("a/f%d.png", 2) == Paths{"a/f0.png", "a/f1.png"});
  CHECK(session::frame_paths("a%d/f-%04d-x.tif", 2) == Paths{"a%d/f-0000-x.tif", "a%d/f-0001-x.tif"});
  CHECK(session::frame_paths("a/f.GIF", 2) == Paths{"a/f.GIF"});
  CHECK(session::frame_paths("f%02d.gif", 2) == Paths{"f00.gif", "f01.gif"});
  for (const char* const wrong : {"f%.png", "f%s.png", "f%d%d.png", "f%12345678901d.png", "f%99d.png", "50%"})
    CHECK(testing::usage_error_of([&] { session::frame_paths(wrong, 2); }).find("out_%03d.png") != std::string::npos);
}

TEST_CASE("frames are requested by a count or by a file of cameras") {
  CHECK_FALSE(FramesRequest{}.is_asked());
  CHECK(Parsed<FramesRequest>({"--frames", "2"}).options.is_asked());
  CHECK(Parsed<FramesRequest>({"--cameras", "c.txt"}).options.is_asked());
  const Parsed<FramesRequest> orbit({"--frames", "4", "--orbit", "-90.5"});
  CHECK(orbit.options.orbit == -90.5);
  const Parsed<FramesRequest> alone({"--orbit", "90"});
  CHECK(testing::usage_error_of([&] {
          static_cast<void>(alone.options.is_asked());
        }).find("--orbit: needs several frames") == 0);
  for (const char* const wrong : {"0", "1001", "x"})
    CHECK(testing::option_error<FramesRequest>({"--frames", wrong}) != "");
  CHECK(testing::option_error<FramesRequest>({"--frames", "2", "--cameras", "c.txt"}) != "");
  CHECK(testing::option_error<FramesRequest>({"--orbit", "2", "--cameras", "c.txt"}) != "");
}
