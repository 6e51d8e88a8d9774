#include "cases/observables/estimators.hpp"
#include "cases/observables/observables.hpp"

#include "cases/measure/bed/displacement_spectrum.hpp"
#include "cases/measure/bed/energy_balance.hpp"
#include "cases/measure/bed/flow_depth.hpp"
#include "cases/measure/bed/lattice_order.hpp"
#include "cases/measure/bed/lid_height.hpp"
#include "cases/measure/bed/velocity_spectrum.hpp"
#include "cases/measure/collision/momentum.hpp"
#include "cases/measure/collision/pair_collision.hpp"
#include "cases/measure/collision/plate_bounce.hpp"
#include "cases/measure/collision/trajectory.hpp"
#include "cases/scene/preparation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

namespace crossgrain::observables {
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

/// Throws std::invalid_argument for what is no whole number of at most 10^6.
int whole_or(const ObservableRequest& request, const char* option, int standard) {
    constexpr double most = 1e6;
    const double value = number_or(request, option, standard);
    if (value == std::round(value) && std::abs(value) <= most) return static_cast<int>(value);
    throw std::invalid_argument(
        fmt::format("{} = {:g} is no whole number of at most {:g}", option, value, most));
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

std::vector<double> numbers_of(const ObservableRequest& request, const char* option) {
    const auto found = request.options.find(option);
    return found == request.options.end() ? std::vector<double>{} : found->second.numbers;
}

std::optional<double> number_of(const ObservableRequest& request, const char* option) {
    const std::vector<double> numbers = numbers_of(request, option);
    return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

EstimatorPointer make_energy_balance(const Scene& scene, const ObservableRequest& request) {
    measure::EnergyBalanceOptions options{.skip = number_or(request, "skip", 0)};
    options.samples_per_frame = whole_or(request, "samples_per_frame", options.samples_per_frame);
    options.accurate_within = number_of(request, "accurate_within");
    // A map asks also what happens at time steps near the contact time.
    if (options.accurate_within) options.least_frames_per_contact_time = 0;
    return std::make_unique<measure::EnergyBalance>(scene, options);
}

EstimatorPointer make_velocity_spectrum(const Scene& scene, const ObservableRequest& request) {
    measure::VelocitySpectrumOptions options{.clock = number_or(request, "clock", 0),
                                             .times = numbers_of(request, "at"),
                                             .phases = numbers_of(request, "phases"),
                                             .skip = number_or(request, "skip", 0),
                                             .from = number_of(request, "from"),
                                             .to = number_of(request, "to")};
    options.k_min = whole_or(request, "k_min", options.k_min);
    options.k_max = whole_or(request, "k_max", options.k_max);
    return std::make_unique<measure::VelocitySpectrum>(scene, options);
}

EstimatorPointer make_flow_depth(const Scene& scene, const ObservableRequest& request) {
    measure::FlowDepthOptions options{.skip = number_or(request, "skip", 0)};
    options.share = number_or(request, "share", options.share);
    return std::make_unique<measure::FlowDepth>(scene, options);
}

/// Throws std::invalid_argument for an unknown word.
measure::Crossing crossing_of(const ObservableRequest& request) {
    const auto found = request.options.find("crossing");
    const std::string word = found == request.options.end() ? "upward" : found->second.text;
    if (word == "upward") return measure::Crossing::upward;
    if (word == "downward") return measure::Crossing::downward;
    if (word == "either") return measure::Crossing::either;
    throw std::invalid_argument(
        fmt::format("crossing is \"{}\", not \"upward\", \"downward\" or \"either\"", word));
}

EstimatorPointer make_displacement_spectrum(const Scene& scene, const ObservableRequest& request) {
    measure::DisplacementSpectrumOptions options{.spacing = number_or(request, "spacing", 0),
                                                 .crossing = crossing_of(request),
                                                 .skip = number_or(request, "skip", 0)};
    options.k_min = whole_or(request, "k_min", options.k_min);
    options.k_max = whole_or(request, "k_max", options.k_max);
    return std::make_unique<measure::DisplacementSpectrum>(scene, options);
}

template <class Estimator>
EstimatorPointer make_plain(const Scene& scene, const ObservableRequest& /*no options*/) {
    return std::make_unique<Estimator>(scene);
}

}  // namespace

const std::vector<GrainObservable>& grain_observables() {
    static const std::vector<GrainObservable> all = [] {
        std::vector<GrainObservable> entries{
            {"pair-collision",
             "collision",
             "restitution, contact_time, speed_ratio, angular_momentum_ratio of isolated pairs",
             {},
             make_plain<measure::PairCollision>},
            {"plate-bounce",
             "collision",
             "plate_restitution, plate_contact_time, plate_momentum_error of isolated grains",
             {},
             make_plain<measure::PlateBounce>},
            {"trajectory",
             "collision",
             "positions at given times, compared between codes",
             {"at_contact_times"},
             make_trajectory},
            {"momentum",
             "collision",
             "momentum_drift_x, momentum_drift_y",
             {},
             make_plain<measure::Momentum>},
            {"energy-balance",
             "bed",
             "energy_residual, mean_energy, mean_energy_input, mean_dissipation, "
             "energy_above_ground, "
             "input_per_period, energy_per_input; energies against time",
             {"skip", "samples_per_frame", "accurate_within"},
             make_energy_balance},
            {"lid-height",
             "bed",
             "mean_lid_height; h(t), bottom and spacing",
             {"skip"},
             make_lid_height},
            {"displacement-spectrum",
             "bed",
             "S(K, Y) by groups of layers, slope_..., slope_tail_..., displacement_vectors, the "
             "last "
             "vector of every grain",
             {"spacing", "skip", "crossing", "k_min", "k_max"},
             make_displacement_spectrum},
            {"velocity-spectrum",
             "bed",
             "E(K, t) of a lattice at times, phases or over a window: velocity_slope_..., "
             "transverse_energy_...; slopes against time",
             {"clock", "at", "phases", "skip", "from", "to", "k_min", "k_max"},
             make_velocity_spectrum},
            {"lattice-order",
             "bed",
             "foreign_contacts, lattice_kept_until: whether rows slid through each other",
             {},
             make_plain<measure::LatticeOrder>},
            {"flow-depth",
             "bed",
             "flow_depth, flowing_layers, lost_bonds of a vibrated bed; lost bonds by layer",
             {"skip", "share"},
             make_flow_depth},
            // tools/new.sh observable: entries go above this line
        };
        const auto& flow = flow_observables();
        entries.insert(entries.end(), flow.begin(), flow.end());
        return entries;
    }();
    return all;
}

std::vector<ObservableText> observable_texts() {
    std::vector<ObservableText> texts;
    const auto add = [&](const char* model, const auto& entries) {
        for (const auto& entry : entries)
            texts.push_back({entry.name, model, entry.measures, entry.options});
    };
    add("grains", grain_observables());
    add("lattice-gas", gas_observables());
    add("hopper-automaton", hopper_observables());
    return texts;
}

std::vector<std::string> source_folders(const catalog::Case& the_case) {
    // The lists here say which options an estimator gets.
    std::set<std::string> folders{"cases/observables"};
    const auto scene = the_case.scene(0, 0, 1);
    std::visit(
        [&](const auto& own) {
            for (const auto& request : the_case.observables) {
                const auto& entry = entry_for(observables_of(own), the_case, request);
                folders.insert("cases/measure/" + entry.folder);
            }
        },
        scene);
    return {folders.begin(), folders.end()};
}

void check_observables(const catalog::Case& the_case) {
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        auto scene = the_case.scene(variant, 0, 1);
        if (auto* grains = std::get_if<Scene>(&scene)) {
            *grains = scene::without_removed(std::move(*grains));
        }
        std::visit([&](const auto& own) { (void)make_estimators(the_case, own); }, scene);
    }
}

}  // namespace crossgrain::observables
