// The observables of the hopper automaton.
#include "cases/observables/model_observables.hpp"

#include "cases/measure/hopper/hopper_damage.hpp"
#include "cases/measure/hopper/hopper_flow.hpp"
#include "cases/measure/hopper/hopper_pattern.hpp"
#include "cases/measure/hopper/hopper_picture.hpp"
#include "cases/measure/hopper/hopper_stagnation.hpp"
#include "cases/measure/hopper/hopper_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::observables {
namespace {

using catalog::ObservableRequest;
using scene::HopperAutomaton;
using EstimatorPointer = std::unique_ptr<measure::HopperEstimator>;

std::vector<double> numbers(const ObservableRequest& request, const char* option) {
    const auto found = request.options.find(option);
    return found == request.options.end() ? std::vector<double>{} : found->second.numbers;
}

double number_or(const ObservableRequest& request, const char* option, double standard) {
    const auto given = numbers(request, option);
    return given.empty() ? standard : given.front();
}

std::int64_t whole(const char* option, double value) {
    if (value >= 0 && value == std::floor(value) && value < 1e15) {
        return static_cast<std::int64_t>(value);
    }
    throw std::invalid_argument(
        fmt::format("'{}' = {:g} is no whole number of iterations", option, value));
}

std::vector<std::int64_t> iterations(const ObservableRequest& request, const char* option) {
    std::vector<std::int64_t> result;
    for (const double value : numbers(request, option))
        result.push_back(whole(option, value));
    return result;
}

EstimatorPointer make_stagnation(const HopperAutomaton& scene, const ObservableRequest& request) {
    measure::HopperStagnationOptions options{.at = iterations(request, "at")};
    if (request.options.contains("profile_at")) {
        options.profile_at = number_or(request, "profile_at", 0);
    }
    return std::make_unique<measure::HopperStagnation>(scene, std::move(options));
}

EstimatorPointer make_flow(const HopperAutomaton& scene, const ObservableRequest& request) {
    measure::HopperFlowOptions options;
    options.down_to = number_or(request, "down_to", options.down_to);
    return std::make_unique<measure::HopperFlow>(scene, options);
}

EstimatorPointer make_pattern(const HopperAutomaton& scene, const ObservableRequest& request) {
    measure::HopperPatternOptions options;
    options.half_width = number_or(request, "half_width", options.half_width);
    options.from = number_or(request, "from", options.from);
    options.to = number_or(request, "to", options.to);
    options.lag = whole("lag", number_or(request, "lag", static_cast<double>(options.lag)));
    options.window =
        whole("window", number_or(request, "window", static_cast<double>(options.window)));
    return std::make_unique<measure::HopperPattern>(scene, options);
}

EstimatorPointer make_picture(const HopperAutomaton& scene, const ObservableRequest& request) {
    measure::HopperPictureOptions options{.at = iterations(request, "at")};
    const double largest = number_or(request, "largest", static_cast<double>(options.largest));
    options.largest = static_cast<std::size_t>(std::clamp(largest, 0.0, 4096.0));
    return std::make_unique<measure::HopperPicture>(scene, options);
}

EstimatorPointer make_surface(const HopperAutomaton& scene, const ObservableRequest&) {
    return std::make_unique<measure::HopperSurface>(scene);
}

EstimatorPointer make_damage(const HopperAutomaton& scene, const ObservableRequest&) {
    return std::make_unique<measure::HopperDamage>(scene);
}

}  // namespace

const std::vector<HopperObservable>& hopper_observables() {
    static const std::vector<HopperObservable> all{
        {"hopper-stagnation",
         "hopper",
         "moving_fraction (P), exponent_..., critical_angle...; P(theta) and its fits, the wall's "
         "profile",
         {"at", "profile_at"},
         make_stagnation},
        {"hopper-flow",
         "hopper",
         "flow_rate, flow_exponent, filling_at_first_loss, residue; rate and filling against "
         "iterations",
         {"down_to"},
         make_flow},
        {"hopper-surface",
         "hopper",
         "crater_depth, crater_half_width, surface_slope, surface_slope_steepest, "
         "surface_scatter; the profile",
         {},
         make_surface},
        {"hopper-pattern",
         "hopper",
         "neighbour_correlation, correlation_length_x and _y, vertical_fraction, "
         "pattern_velocity..., asymmetry, mirror_imbalance_sites and _grains; state",
         {"half_width", "from", "to", "lag", "window"},
         make_pattern},
        {"hopper-damage",
         "hopper",
         "damage, damaged_trials, shape_difference of twins; damage against iterations",
         {},
         make_damage},
        {"hopper-picture",
         "hopper",
         "the orientations and the free surface",
         {"at", "largest"},
         make_picture},
    };
    return all;
}

}  // namespace crossgrain::observables
