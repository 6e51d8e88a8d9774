#include "adapters/dump/dump_box.hpp"

#include "adapters/dump/dump_number.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::adapters::dump {
namespace {

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
/// Bounds are written with 17 digits, or with six by careless writers.
constexpr double same_length = 1e-5;
constexpr std::size_t longest_quoted = 60;

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view blanks = " \t";
    while (true) {
        const auto begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return words;
        line.remove_prefix(begin);
        const auto end = std::min(line.find_first_of(blanks), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

}  // namespace

Box::Box(std::string_view item, const scene::Scene& scene) {
    constexpr std::string_view title = "ITEM: BOX BOUNDS";
    auto words = words_of(item.substr(title.size()));
    if (words.size() == 6) words.erase(words.begin(), words.begin() + 3);  // xy xz yz
    if (words.size() != 3) return;
    const std::array<std::optional<double>, 2> of_scene = {scene.periodic_x, scene.periodic_y};
    for (std::size_t axis = 0; axis < of_scene.size(); ++axis) {
        const bool periodic = words[axis] == "pp";
        if (periodic != of_scene[axis].has_value()) {
            mismatch_ = fmt::format(
                "the box is {}periodic along {} ('{}'), the scene is {}", periodic ? "" : "not ",
                axes[axis], printable(words[axis], longest_quoted),
                of_scene[axis] ? fmt::format("with period {:g}", *of_scene[axis]) : "not");
            if (axis == 0 || words[axis] != "ss") throw TrajectoryError(mismatch_);
            continue;
        }
        periods_[axis] = of_scene[axis].value_or(0);
    }
}

void Box::take_bounds(std::string_view line) {
    const auto words = words_of(line);
    const std::size_t axis = axis_++;
    std::vector<double> numbers;
    for (const auto word : words) {
        const auto value = dump_number<double>(word);
        if (!value) break;
        numbers.push_back(*value);
    }
    if (numbers.size() != words.size() || numbers.size() < 2 || numbers.size() > 3) {
        throw TrajectoryError(fmt::format("'{}' are no bounds along {} (lo hi, or lo hi tilt)",
                                          printable(line, longest_quoted), axes[axis]));
    }
    if (numbers.size() == 3 && numbers[2] != 0) {
        throw TrajectoryError(
            fmt::format("the box is tilted by {:g}; scenes have right angles", numbers[2]));
    }
    const bool own = line == "-0.5 0.5";
    if (axis + 1 == axes.size() && !own && !mismatch_.empty()) throw TrajectoryError(mismatch_);
    const double length = numbers[1] - numbers[0];
    if (periods_[axis] > 0 && !(std::abs(length / periods_[axis] - 1) <= same_length)) {
        throw TrajectoryError(
            fmt::format("the box is {:g} long along {}, the scene has period {:g}", length,
                        axes[axis], periods_[axis]));
    }
}

}  // namespace crossgrain::adapters::dump
