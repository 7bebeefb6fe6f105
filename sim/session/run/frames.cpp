#include "sim/session/run/frames.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "host/setup/camera.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/isa/describe.h"
#include "hw/machines/timing.h"
#include "sim/cycle/sequence.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/long_work.h"
#include "sim/session/model/cameras.h"
#include "sim/session/model/frame_compiler.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/configuration.h"
#include "sim/session/run/frame_pictures.h"
#include "sim/session/run/memory.h"

namespace csgsim::session {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Rejects options that apply to a single frame, and reads the cameras of --cameras; empty without that option.
std::vector<view::Camera> checked_cameras(const RenderRequest& request, const FramesRequest& wanted) {
  const char* const remedy = wanted.cameras.empty() ? "--frames" : "--cameras";
  const auto for_one_frame = std::to_array<std::pair<const char*, bool>>({
      {"--depth", !request.run.depth.empty()},
      {"--owner", !request.run.owner.empty()},
      {"--report", !request.run.report.file.empty()},
      {"--check", request.check},
      {"--advice", request.run.advice},
      {"--max-wrong-pixels", request.max_wrong_pixels.has_value()},
  });
  for (const auto& [option, is_given] : for_one_frame)
    if (is_given) throw UsageError(option, fmt::format("is for one frame; leave out {}", remedy));
  if (wanted.orbit && !std::isfinite(*wanted.orbit))
    throw UsageError("--orbit", "is not a finite number of degrees; give one such as 360");
  std::vector<view::Camera> cameras;
  if (!wanted.cameras.empty()) cameras = read_cameras(wanted.cameras, max_frames);
  if (!request.run.picture.empty() && is_stream(request.run.picture))
    throw UsageError("--output",
                     fmt::format("several pictures do not fit into one stream; name a file, or leave out {}", remedy));
  return cameras;
}

/// The camera of each frame; `given` are those of --cameras.
std::vector<view::Camera> cameras_of(const CompiledModel& model, const std::vector<view::Camera>& given,
                                     const FramesRequest& wanted, const machines::Machine& machine) {
  std::vector<view::Camera> cameras;
  setup::CameraChoice choice = model.choices.camera;
  for (const view::Camera& camera : given) {
    choice.given = camera;
    cameras.push_back(setup::camera_for(choice, machine.picture, model.tree, model.scene));
  }
  if (!given.empty()) return cameras;
  const double step = wanted.orbit.value_or(0) / wanted.frames;
  for (std::uint32_t i = 0; i < wanted.frames; ++i)
    cameras.push_back(view::turned(model.camera, i * step * std::numbers::pi / 180.0));
  return cameras;
}

isa::Preparation prepared_for(const isa::Program& program) {
  isa::Preparation all = *program.preparation;
  for (const isa::Segment& segment : program.segments) all += *segment.preparation;
  return all;
}

FrameCounts counts_of(const isa::Program& program, const engine::RunResult& result, const observe::Stats& stats,
                      const csg::ReuseCounts& reused) {
  const isa::CompileFacts& compile = program.facts->compile;
  return {.clocks = result.clocks,
          .shown_clocks = result.shown_clocks,
          .interval_clocks = result.interval_clocks,
          .host_clocks = result.host_clocks,
          .host_model_clocks = result.host_model_clocks,
          .paced_clocks = machines::paced_clocks(result.interval_clocks, result.host_clocks),
          .skipped = result.skipped,
          .rendered = compile.rendered,
          .classified = compile.classified,
          .depth_tests = compile.depth_tests,
          .cost = stats.total,
          .prepared = prepared_for(program),
          .reused = reused};
}

/// The observers of one frame, combined into one, since cycle::run_sequence() takes one observer per Program.
struct FrameRun final : engine::Observer {
  explicit FrameRun(const isa::Program& program) : picture(program), stats(program) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const override {
    return picture.reads_after(instruction);
  }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    picture.after_instruction(step, state);
    stats.after_instruction(step, state);
  }
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    picture.after_segment(segment, state);
  }

  observe::FrameObserver picture;
  observe::StatsObserver stats;
};

/// Returns the configuration for the stats; called with the Program of the first frame.
using Configure = std::function<Json(const isa::Program& first)>;

class FrameDrawing {
 public:
  FrameDrawing(const RenderRequest& request, const machines::Machine& machine, std::vector<view::Camera> cameras,
               FramePictures& pictures, const FrameProgress& progress, Configure configure)
      : request_(request),
        machine_(machine),
        cameras_(std::move(cameras)),
        pictures_(pictures),
        progress_(progress),
        configure_(std::move(configure)),
        form_(evaluator_form(request.run.evaluator, request.run.level)),
        work_(long_run_warning(request.run.level)) {}

  DrawnFrames of_moving_camera(FrameCompiler& compiler) {
    for (std::size_t i = 0; i < cameras_.size(); ++i) {
      begin(i);
      run(compiler.compile(cameras_[i]), compiler.reused());
    }
    return finish();
  }

  DrawnFrames of_still_camera(FrameCompiler& compiler) {
    repeats_ = true;
    const isa::Program program = compile_for_camera(cameras_.front(), compiler.model(), machine_);
    if (request_.run.level == "cycle") {
      run_sequence(std::vector(cameras_.size(), program));
    } else {
      for (std::size_t i = 0; i < cameras_.size(); ++i) {
        begin(i);
        run(program, {});
      }
    }
    return finish();
  }

  /// The configuration, null if it is not requested; valid after the first frame.
  [[nodiscard]] Json configuration() const { return configuration_; }

 private:
  void begin(std::size_t frame) {
    if (frame > 0) work_.record_points(frame, cameras_.size());
    progress_(frame, cameras_.size());
  }

  void run(const isa::Program& program, const csg::ReuseCounts& reused) {
    with_memory_for_run({&program, 1}, machine_.array, [&] {
      if (!engine_) engine_ = make_engine(machine_, request_.run.level, request_.run.threads, form_);
      FrameRun frame(program);
      const std::array<engine::Observer*, 2> observers{&frame.picture, &frame.stats};
      put(program, engine_->run(program, observers), frame, reused);
    });
  }

  void run_sequence(const std::vector<isa::Program>& programs) {
    with_memory_for_run(programs, machine_.array, [&] {
      std::deque<FrameRun> runs;
      std::vector<engine::Observer*> observers;
      for (const isa::Program& program : programs) observers.push_back(&runs.emplace_back(program));
      const std::vector<engine::RunResult> results = cycle::run_sequence(machine_, programs, observers, form_);
      for (std::size_t i = 0; i < results.size(); ++i) put(programs[i], results[i], runs[i], {});
    });
  }

  void put(const isa::Program& program, const engine::RunResult& result, FrameRun& run,
           const csg::ReuseCounts& reused) {
    refuse_overflow(result);
    observe::Frame picture = std::move(run.picture).frame();
    if (!result.scanned_out.empty()) picture.colour = result.scanned_out;
    pictures_.write(picture, program);
    const std::size_t number = drawn_.frames.size();
    if (number == 0 && configure_) configuration_ = configure_(program);
    FrameCounts counts = counts_of(program, result, run.stats.stats(), reused);
    // A Program drawn again still records the work for the model, which only the first frame did.
    if (number > 0 && repeats_) counts.host_model_clocks = 0;
    drawn_.sums += counts;
    drawn_.frames.push_back({cameras_[number], pictures_.file_of(number), std::move(counts)});
  }

  DrawnFrames finish() {
    pictures_.finish();
    drawn_.machine = machine_;
    return std::move(drawn_);
  }

  const RenderRequest& request_;
  const machines::Machine& machine_;
  std::vector<view::Camera> cameras_;
  FramePictures& pictures_;
  const FrameProgress& progress_;
  Configure configure_;
  Json configuration_;
  systemc::EvaluatorForm form_;
  observe::LongWork work_;
  std::unique_ptr<engine::Engine> engine_;
  bool repeats_ = false;  ///< whether all frames are drawn by one Program
  DrawnFrames drawn_;
};

Json point_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json counts_json(const FrameCounts& counts) {
  Json prepared = Json::object();
  isa::describe(counts.prepared,
                [&](std::string_view key, std::uint64_t count) { prepared[std::string(key)] = count; });
  const csg::ReuseCounts& reused = counts.reused;
  return {{"clocks", counts.clocks},
          {"shown_clocks", counts.shown_clocks},
          {"interval_clocks", counts.interval_clocks},
          {"host_clocks", counts.host_clocks},
          {"host_model_clocks", counts.host_model_clocks},
          {"instructions", {{"total", counts.cost.instructions}, {"skipped", counts.skipped}}},
          {"pixel_operations", {{"total", counts.cost.pixel_operations}, {"enabled", counts.cost.enabled}}},
          {"scan_conversions", {{"rendered", counts.rendered}, {"classified", counts.classified}}},
          {"depth_tests", counts.depth_tests},
          {"host",
           {{"prepared", prepared},
            {"reused",
             {{"lookups", reused.lookups},
              {"trees", reused.trees},
              {"nodes", reused.nodes},
              {"certificates", reused.certificates}}}}}};
}

Json frame_json(const DrawnFrame& frame, std::size_t number) {
  Json json{{"frame", number},
            {"camera",
             {{"eye", point_json(frame.camera.eye)},
              {"centre", point_json(frame.camera.centre)},
              {"up", point_json(frame.camera.up)}}}};
  if (!frame.picture.empty()) json["picture"] = printable(frame.picture);
  json.update(counts_json(frame.counts));
  return json;
}

Json to_json(const DrawnFrames& drawn, const std::string& level, Json configuration) {
  Json totals{{"frames", drawn.frames.size()},
              {"frames_per_second", drawn.frames_per_second()},
              {"hosted_frames_per_second", drawn.hosted_frames_per_second()}};
  totals.update(counts_json(drawn.sums));
  Json json{{"machine", drawn.machine.name}, {"level", level}, {"totals", totals}, {"frames", Json::array()}};
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) json["frames"].push_back(frame_json(drawn.frames[i], i));
  json["configuration"] = std::move(configuration);
  return json;
}

double rate(std::size_t frames, std::uint64_t clocks, std::uint64_t clock_hz) {
  return clocks == 0 ? 0 : static_cast<double>(frames) * static_cast<double>(clock_hz) / static_cast<double>(clocks);
}

}  // namespace

void FramesRequest::add_to(OptionList& options) {
  options
      .option("--frames", frames,
              "Draw this number of pictures: files NAME_000.png and so on, out_%03d.png as its mark says, or one "
              "animated .gif")
      .between(1U, max_frames);
  options.option("--orbit", orbit,
                 "Degrees that the camera turns during all --frames, about the vertical axis through its centre; the "
                 "last frame is a step before the end, so that 360 repeats smoothly");
  options
      .option("--cameras", cameras,
              "File with one camera per line, as for --camera; # begins a comment. One picture is drawn for each")
      .check(not_empty)
      .excludes("--frames")
      .excludes("--orbit")
      .excludes("--camera");
}

bool FramesRequest::is_asked() const {
  if (!cameras.empty() || frames > 1) return true;
  if (orbit) throw UsageError("--orbit", "needs several frames; add --frames 36");
  return false;
}

FrameCounts& FrameCounts::operator+=(const FrameCounts& more) {
  clocks += more.clocks;
  shown_clocks += more.shown_clocks;
  interval_clocks += more.interval_clocks;
  host_clocks += more.host_clocks;
  host_model_clocks += more.host_model_clocks;
  paced_clocks += more.paced_clocks;
  skipped += more.skipped;
  rendered += more.rendered;
  classified += more.classified;
  depth_tests += more.depth_tests;
  cost += more.cost;
  prepared += more.prepared;
  reused += more.reused;
  return *this;
}

double DrawnFrames::frames_per_second() const { return rate(frames.size(), sums.interval_clocks, machine.clock_hz); }

double DrawnFrames::hosted_frames_per_second() const {
  return rate(frames.size(), sums.paced_clocks, machine.clock_hz);
}

DrawnFrames draw_frames(const OptionList& options, const RenderRequest& request, const FramesRequest& wanted,
                        const FrameProgress& progress) {
  const std::vector<view::Camera> given = checked_cameras(request, wanted);
  const machines::Machine machine = machine_of(request.model);
  FrameCompiler compiler(request.model, machine);
  const CompiledModel& model = compiler.model();
  const std::vector<view::Camera> cameras = cameras_of(model, given, wanted, machine);
  std::vector<fs::path> paths = frame_paths(request.run.picture, static_cast<std::uint32_t>(cameras.size()));
  std::vector<fs::path> inputs = request.model.inputs();
  if (!wanted.cameras.empty()) inputs.emplace_back(wanted.cameras);
  inputs.insert(inputs.end(), model.tree.imports.begin(), model.tree.imports.end());
  std::vector<fs::path> outputs = paths;
  outputs.emplace_back(request.run.stats);
  refuse_clashes(inputs, outputs);
  refuse_unknown_format("--output", request.run.picture);
  FramePictures pictures(std::move(paths));
  std::optional<OutputFile> stats;
  if (!request.run.stats.empty()) stats.emplace(request.run.stats);
  announce_memory(machine, {machine.picture.width, machine.picture.height, machine.array.memory_bits},
                  request.run.level);
  const auto configure = [&](const isa::Program& first) {
    return configuration_of(options, {.machine = machine,
                                      .program = first,
                                      .inputs = inputs,
                                      .hash = model.hash,
                                      .camera = &cameras.front(),
                                      .scene = &request.model.scene_values()});
  };
  FrameDrawing drawing(request, machine, cameras, pictures, progress, stats ? configure : Configure());
  const bool is_moving = wanted.orbit.value_or(0) != 0 || !wanted.cameras.empty();
  DrawnFrames drawn = is_moving ? drawing.of_moving_camera(compiler) : drawing.of_still_camera(compiler);
  if (!stats) return drawn;
  stats->write(to_json(drawn, request.run.level, drawing.configuration()).dump(2) + "\n");
  stats->commit();
  return drawn;
}

}  // namespace csgsim::session
