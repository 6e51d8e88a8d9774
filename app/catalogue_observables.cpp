#include "app/catalogue.hpp"

#include "cases/measure/displacement_spectrum.hpp"
#include "cases/measure/energy_balance.hpp"
#include "cases/measure/lid_height.hpp"
#include "cases/measure/momentum.hpp"
#include "cases/measure/pair_collision.hpp"
#include "cases/measure/plate_bounce.hpp"
#include "cases/measure/trajectory.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace crossgrain::app {
namespace {

using catalog::ObservableRequest;
using scene::Scene;
using EstimatorPointer = std::unique_ptr<measure::Estimator>;

double number_or(const ObservableRequest& request, const char* option, double standard) {
    const auto found = request.options.find(option);
    return found == request.options.end() || found->second.numbers.empty()
               ? standard
               : found->second.numbers.front();
}

EstimatorPointer make_trajectory(const Scene& scene, const ObservableRequest& request) {
    std::vector<double> times;
    if (const auto at = request.options.find("at_contact_times"); at != request.options.end()) {
        for (const double count : at->second.numbers) {
            times.push_back(count * scene::contact_time(scene));
        }
    }
    return std::make_unique<measure::Trajectory>(scene, measure::TrajectoryOptions{.times = times});
}

EstimatorPointer make_lid_height(const Scene& scene, const ObservableRequest& request) {
    return std::make_unique<measure::LidHeight>(
        scene, measure::LidHeightOptions{.skip = number_or(request, "skip", 0)});
}

EstimatorPointer make_energy_balance(const Scene& scene, const ObservableRequest& request) {
    return std::make_unique<measure::EnergyBalance>(
        scene, measure::EnergyBalanceOptions{.skip = number_or(request, "skip", 0)});
}

EstimatorPointer make_displacement_spectrum(const Scene& scene, const ObservableRequest& request) {
    measure::DisplacementSpectrumOptions options{.spacing = number_or(request, "spacing", 0),
                                                 .crossing = number_or(request, "downward", 0) != 0
                                                                 ? measure::Crossing::downward
                                                                 : measure::Crossing::upward,
                                                 .skip = number_or(request, "skip", 0)};
    options.k_min = static_cast<int>(number_or(request, "k_min", options.k_min));
    options.k_max = static_cast<int>(number_or(request, "k_max", options.k_max));
    return std::make_unique<measure::DisplacementSpectrum>(scene, options);
}

template <class Estimator>
EstimatorPointer make_plain(const Scene& scene, const ObservableRequest& /*no options*/) {
    return std::make_unique<Estimator>(scene);
}

const ObservableEntry& entry_for(const catalog::Case& the_case, const ObservableRequest& request) {
    std::vector<std::string> names;
    for (const auto& entry : observables()) {
        if (entry.name == request.name) return entry;
        names.push_back(entry.name);
    }
    const auto near = toml_input::nearest(request.name, names);
    throw CaseError({.file = the_case.file,
                     .line = request.line,
                     .column = request.column,
                     .key = "observable.name",
                     .problem = "is not known",
                     .got = fmt::format("\"{}\"", request.name),
                     .expected = fmt::format("one of {}", fmt::join(names, ", ")),
                     .hint = near ? fmt::format("did you mean \"{}\"?", *near) : ""});
}

void check_options(const catalog::Case& the_case, const ObservableRequest& request,
                   const ObservableEntry& entry) {
    for (const auto& [name, option] : request.options) {
        if (std::find(entry.options.begin(), entry.options.end(), name) != entry.options.end()) {
            continue;
        }
        const auto near = toml_input::nearest(name, entry.options);
        throw CaseError({.file = the_case.file,
                         .line = option.line,
                         .column = option.column,
                         .key = "observable." + name,
                         .problem = fmt::format("is not an option of '{}'", request.name),
                         .expected = entry.options.empty()
                                         ? "no option"
                                         : fmt::format("one of {}", fmt::join(entry.options, ", ")),
                         .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
    }
}

}  // namespace

const std::vector<ObservableEntry>& observables() {
    static const std::vector<ObservableEntry> all{
        {"pair-collision",
         "restitution, contact_time, speed_ratio, angular_momentum_ratio of isolated pairs",
         {},
         make_plain<measure::PairCollision>},
        {"plate-bounce",
         "plate_restitution, plate_contact_time, plate_momentum_error of isolated grains",
         {},
         make_plain<measure::PlateBounce>},
        {"trajectory",
         "positions at given times, compared between codes",
         {"at_contact_times"},
         make_trajectory},
        {"momentum", "momentum_drift_x, momentum_drift_y", {}, make_plain<measure::Momentum>},
        {"energy-balance",
         "energy_residual, mean_energy, mean_energy_input, mean_dissipation; energies against time",
         {"skip"},
         make_energy_balance},
        {"lid-height", "mean_lid_height; h(t), bottom and spacing", {"skip"}, make_lid_height},
        {"displacement-spectrum",
         "S(K, Y) by groups of layers, slope_..., slope_tail_..., displacement_vectors",
         {"spacing", "skip", "downward", "k_min", "k_max"},
         make_displacement_spectrum},
    };
    return all;
}

std::vector<EstimatorPointer> make_estimators(const catalog::Case& the_case, const Scene& scene) {
    std::vector<EstimatorPointer> estimators;
    for (const auto& request : the_case.observables) {
        const ObservableEntry& entry = entry_for(the_case, request);
        check_options(the_case, request, entry);
        try {
            estimators.push_back(entry.make(scene, request));
        } catch (const std::invalid_argument& error) {
            throw CaseError({.file = the_case.file,
                             .line = request.line,
                             .column = request.column,
                             .key = "observable",
                             .problem = fmt::format("'{}' cannot be measured: {}", request.name,
                                                    error.what())});
        }
    }
    return estimators;
}

void check_observables(const catalog::Case& the_case) {
    for (const auto& request : the_case.observables) {
        check_options(the_case, request, entry_for(the_case, request));
    }
}

}  // namespace crossgrain::app
