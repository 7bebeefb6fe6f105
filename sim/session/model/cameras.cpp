#include "sim/session/model/cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "hw/base/error.h"
#include "hw/base/input_file.h"

namespace csgsim::session {

namespace {

constexpr std::size_t numbers_of_eye_and_centre = 6;
constexpr std::size_t numbers_of_gimbal = 7;
constexpr const char* blanks = " \t\r";
constexpr InputKind camera_input{"a file of cameras", 1'000'000, "split it into several"};

/// A number and its position in the text.
struct PlacedNumber {
  double value = 0;
  std::size_t at = 0;
};

std::vector<PlacedNumber> placed_numbers(std::string_view text) {
  std::vector<PlacedNumber> numbers;
  for (std::size_t at = 0;; ++at) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    PlacedNumber number{0, at};
    const char* const last = text.data() + end;
    const auto [next, error] = std::from_chars(text.data() + at, last, number.value);
    if (error != std::errc{} || next != last) {
      throw CameraError(at, fmt::format("'{}' is not of the form ex,ey,ez,cx,cy,cz or x,y,z,rx,ry,rz,d", text));
    }
    numbers.push_back(number);
    if (end == text.size()) return numbers;
    at = end;
  }
}

}  // namespace

view::Camera parse_camera(std::string_view text) {
  const std::vector<PlacedNumber> n = placed_numbers(text);
  const bool is_gimbal = n.size() == numbers_of_gimbal;
  if (!is_gimbal && n.size() != numbers_of_eye_and_centre)
    throw CameraError(0, fmt::format("'{}' is not of the form ex,ey,ez,cx,cy,cz or x,y,z,rx,ry,rz,d", text));
  const glm::dvec3 first(n[0].value, n[1].value, n[2].value);
  const glm::dvec3 second(n[3].value, n[4].value, n[5].value);
  if (is_gimbal && !(n[6].value > 0)) throw CameraError(n[6].at, "the distance (last number) must be above 0");
  const view::Camera camera = is_gimbal ? view::gimbal_camera(first, second, n[6].value) : view::Camera{first, second};
  try {
    view::basis(camera);
  } catch (const InputError& error) {
    throw CameraError(0, error.what());
  }
  return camera;
}

std::vector<view::Camera> read_cameras(const std::filesystem::path& path, std::size_t max_cameras) {
  const std::string text = read_file(path, camera_input);
  const std::string name = path.native();
  std::vector<view::Camera> cameras;
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view rest = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    rest = rest.substr(0, rest.find('#'));
    const std::size_t indent = rest.find_first_not_of(blanks);
    if (indent == rest.npos) continue;
    rest = rest.substr(indent, rest.find_last_not_of(blanks) + 1 - indent);
    try {
      if (cameras.size() == max_cameras)
        throw CameraError(0, fmt::format("more than {} cameras; split the file into several", max_cameras));
      cameras.push_back(parse_camera(rest));
    } catch (const CameraError& error) {
      throw InputError(fmt::format("{}:{}:{}: {}", name, line, indent + error.at() + 1, error.what()));
    }
  }
  if (cameras.empty()) throw InputError(name + ": no camera; write one per line, as for --camera");
  return cameras;
}

}  // namespace csgsim::session
