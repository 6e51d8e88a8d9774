#include "cases/scene/any_scene.hpp"

#include "cases/scene/model_json.hpp"
#include "cases/scene/scene_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::scene {
namespace {

std::string model(const Scene&) {
    return "grains";
}
std::string model(const LatticeGas&) {
    return "lattice-gas";
}
std::string model(const HopperAutomaton&) {
    return "hopper-automaton";
}
std::string model(const SyntheticSignal&) {
    return "synthetic-signal";
}

Work work(const Scene& s) {
    return {static_cast<double>(s.grain_count()) * static_cast<double>(s.steps), "particle-steps"};
}
Work work(const LatticeGas& s) {
    const GasSampling& g = s.sampling;
    return {static_cast<double>(g.length) * g.width * g.replicas *
                static_cast<double>(g.burn_in + g.steps),
            "site-updates"};
}
Work work(const SyntheticSignal& s) {
    const GasSampling& g = s.sampling;
    return {static_cast<double>(g.bins()) * g.replicas * static_cast<double>(g.frames()), "counts"};
}
/// Every hole of the outlet moves at most through all levels, one or two at a time.
Work work(const HopperAutomaton& s) {
    return {static_cast<double>(s.angles.size()) * s.replicas * (s.flipped > 0 ? 2 : 1) *
                static_cast<double>(s.iterations) * s.outlet * s.levels,
            "grain-moves (bound)"};
}

}  // namespace

std::string model_of(const AnyScene& scene) {
    return std::visit([](const auto& s) { return model(s); }, scene);
}

const std::string& name_of(const AnyScene& scene) {
    return std::visit([](const auto& s) -> const std::string& { return s.name; }, scene);
}

std::uint64_t seed_of(const AnyScene& scene) {
    return std::visit([](const auto& s) { return s.seed; }, scene);
}

double time_step_of(const AnyScene& scene) {
    const auto* grains = std::get_if<Scene>(&scene);
    return grains == nullptr ? 0 : grains->dt;
}

Work work_of(const AnyScene& scene) {
    return std::visit([](const auto& s) { return work(s); }, scene);
}

double bytes_of(const AnyScene& scene) {
    constexpr double without_grains = 2048, per_grain = 8 * sizeof(double);
    const auto* grains = std::get_if<Scene>(&scene);
    if (grains == nullptr) return without_grains;
    return without_grains + per_grain * static_cast<double>(grains->grain_count());
}

std::vector<std::string> warnings_of(const AnyScene& scene) {
    const auto* hopper = std::get_if<HopperAutomaton>(&scene);
    if (hopper == nullptr || hopper->angles.empty()) return {};
    constexpr double steepest = 120;  // degrees; the lattice's own walls
    const double widest = *std::max_element(hopper->angles.begin(), hopper->angles.end());
    if (widest <= steepest) return {};
    return {fmt::format(
        "{}: theta = {:g} degrees: beyond 120 grains stay behind for good, P(theta) has "
        "no meaning and is not given",
        hopper->name, widest)};
}

nlohmann::json identity_json(const AnyScene& scene) {
    return std::visit(
        [](auto s) {
            s.name.clear();  // a label: renaming a case must not recompute it
            return to_json(s);
        },
        scene);
}

nlohmann::json settings_json(const AnyScene& scene) {
    return std::visit([](const auto& s) { return settings_json(s); }, scene);
}

}  // namespace crossgrain::scene
