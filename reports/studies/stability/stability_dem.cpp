#include "reports/studies/stability/stability_dem.hpp"

#include "adapters/registry/codes.hpp"

#include "reports/studies/stability/stability_scenes.hpp"
#include "reports/studies/stability/stability_search.hpp"

#include "cases/measure/bed/energy_balance.hpp"
#include "native/base/errors.hpp"
#include "reference/analytic/packing_stability.hpp"
#include "reference/analytic/scheme_stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace crossgrain::studies {
namespace {

using adapters::GrainCode;
using scene::Integrator;
using scene::Scene;

constexpr double other_restitution = 0.5;
constexpr const char* lattice_theory = "analytic:lattice_time_step_limit";
constexpr const char* packing_theory = "analytic:packing_time_step_limit";

struct Method {
    Integrator integrator;
    analytic::TimeScheme theory;
    bool stable_without_damping;
};

/// The adaptive scheme shortens its steps when grains move fast: a perturbation that grows from
/// rest finds it at its longest step, where it is Taguchi's Euler.
constexpr std::array methods{
    Method{Integrator::verlet_predicted, analytic::TimeScheme::predicted_verlet, true},
    Method{Integrator::verlet_half_step, analytic::TimeScheme::half_step_verlet, true},
    Method{Integrator::leapfrog_crank_nicolson, analytic::TimeScheme::crank_nicolson_leapfrog,
           true},
    Method{Integrator::semi_implicit_euler, analytic::TimeScheme::semi_implicit_euler, true},
    Method{Integrator::explicit_euler, analytic::TimeScheme::explicit_euler, false},
    Method{Integrator::taguchi_euler, analytic::TimeScheme::taguchi_euler, false},
    Method{Integrator::taguchi_adaptive_euler, analytic::TimeScheme::taguchi_euler, false},
    Method{Integrator::runge_kutta_4, analytic::TimeScheme::runge_kutta_4, true}};

std::string method_name(const Scene& packing, double restitution, ContactState state) {
    return fmt::format("{}, e = {:g}, {} damping, {} contacts{}",
                       scene::to_string(packing.integrator), restitution,
                       scene::to_string(packing.contact.damping_acts_on),
                       state == ContactState::closed ? "closed" : "open",
                       packing.plates.bottom ? " between plates" : "");
}

/// Whether a trial can tell the limit. Where a pair z of the Euler schemes leaves the unit disc
/// slowly, the energy of its mode grows per step by |z - 1|^2 (Taguchi's scheme: half of that)
/// times the excess over the limit: at twice the tolerance it must rise within the trial as far as
/// that looks for. Other schemes leave the disc fast.
bool resolved_by_trial(analytic::TimeScheme scheme, std::complex<double> z, double tolerance) {
    const bool taguchi = scheme == analytic::TimeScheme::taguchi_euler;
    if (!taguchi && scheme != analytic::TimeScheme::explicit_euler) return true;
    const double growth = std::norm(z - 1.0) * (taguchi ? 0.5 : 1.0);
    return growth * 2 * tolerance * static_cast<double>(steps_of_trial) >= std::log(rise_of_trial);
}

/// Limits by scheme and law: two integrators may share a scheme.
using PackingLimits = std::map<std::string, PackingTheory>;

const PackingTheory& limit_of_packing(const Scene& packing, analytic::TimeScheme scheme,
                                      PackingLimits& known) {
    const auto& law = packing.contact;
    const auto [entry, is_new] =
        known.try_emplace(fmt::format("{} {} {} {}", static_cast<int>(scheme), law.stiffness,
                                      law.damping, scene::to_string(law.damping_acts_on)));
    if (is_new) {
        const auto limit = analytic::packing_time_step_limit(scheme, closed_packing(packing));
        entry->second = {limit->dt, limit->eigenvalue, limit->residual};
    }
    return entry->second;
}

double limit_in_lattice(const Scene& scene, analytic::TimeScheme scheme) {
    const auto& law = scene.contact;
    return analytic::lattice_time_step_limit(scheme, law.stiffness, law.damping, scene.grains.mass,
                                             law.damping_acts_on == scene::Damping::full_vector
                                                 ? analytic::Damping::full_vector
                                                 : analytic::Damping::normal_only);
}

/// A code that is here and can run the packing.
struct Runner {
    const GrainCode* code;
    adapters::Availability available;
};

std::vector<Runner> runners_of(const Scene& packing,
                               const std::vector<const adapters::Code*>& codes) {
    std::vector<Runner> runners;
    for (const auto* code : codes) {
        const auto* runner = dynamic_cast<const GrainCode*>(code);
        if (runner == nullptr || runner->cannot_express(packing)) continue;
        if (auto available = code->probe(); available.installed)
            runners.push_back({runner, std::move(available)});
    }
    return runners;
}

/// In all codes that can run the packing; in the first alone where there is no theory.
void add_searches(const Scene& model, const Method& method, double restitution, ContactState state,
                  const std::vector<const adapters::Code*>& codes, PackingLimits& limits,
                  std::vector<ThresholdSearch>& searches) {
    Scene with_law = model;
    with_law.contact = with_restitution(model, restitution);
    Scene packing = packing_scene(with_law, state);
    packing.integrator = method.integrator;
    packing.steps = packing.frame_every = 1;
    packing.dt = limit_in_lattice(packing, method.theory);
    std::vector<Runner> runners = runners_of(packing, codes);
    if (runners.empty()) return;
    StabilityThreshold found{.method = method_name(packing, restitution, state),
                             .parameter = "dt",
                             .theory_source = packing_theory,
                             .tolerance = 0.01};
    if (state == ContactState::closed) {
        const PackingTheory& theory = limit_of_packing(packing, method.theory, limits);
        found.packing = theory;
        if (theory.limit > 0) packing.dt = theory.limit;
        if (theory.limit > 0 &&
            resolved_by_trial(method.theory, theory.eigenvalue, found.tolerance))
            found.theory = theory.limit;
    } else {
        runners.resize(1);
    }
    for (const auto& [code, available] : runners) {
        found.code = code->name();
        searches.push_back({code, available.version, available.digest, packing, packing.dt, found});
    }
}

std::vector<ThresholdSearch> searches_for(const Scene& given, const run::Settings& settings) {
    const auto codes = adapters::select_codes(settings.codes);
    const double own =
        std::exp(-given.contact.damping / given.grains.mass * scene::contact_time(given));
    std::vector<ThresholdSearch> searches;
    PackingLimits limits;
    for (const Method& method : methods) {
        for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
            Scene model = given;
            model.contact.damping_acts_on = damping;
            for (const double restitution : {own, other_restitution})
                add_searches(model, method, restitution, ContactState::closed, codes, limits,
                             searches);
            add_searches(model, method, own, ContactState::open, codes, limits, searches);
        }
        if (method.stable_without_damping)
            add_searches(given, method, 1, ContactState::closed, codes, limits, searches);
    }
    return searches;
}

void add_residual(const StabilityTrial& trial, Scene scene, double dt, StabilityReport& report) {
    scene.dt = dt;
    scene.frame_every = 1;
    scene.steps = std::llround(3 * scene.plates.bottom->period / dt);
    // Powers are sampled eight times per 0.008 or per step, so that the sum does not decide.
    measure::EnergyBalanceOptions options;
    options.samples_per_frame = dt < 0.02 * scene::contact_time(scene) ? 2 : 8;
    options.least_frames_per_contact_time = 0;
    measure::EnergyBalance balance(scene, options);
    const bool finished = trial.run(scene, [&](const scene::Frame& frame) { balance.add(frame); });
    StabilityPoint point{.code = trial.code().name(),
                         .at = {{"dt", dt}},
                         .in = {{"integrator", scene::to_string(scene.integrator)}},
                         .state = "blow-up",
                         .detail = "a grain has left all bounds"};
    if (finished) {
        measure::Results results;
        balance.finish(results);
        for (const auto& m : results.measurements) {
            if (m.observable != "energy_residual") continue;
            point.state = measure::energy_state(m.value, 0.01);
            point.detail = fmt::format("energy residual {:+.3g} %", 100 * m.value);
        }
    }
    report.points.push_back(std::move(point));
}

/// In the first code that has the integrator.
void add_residuals(const Scene& given, const run::Settings& settings, const std::stop_token& stop,
                   StabilityReport& report) {
    constexpr std::array steps_in_contact_time{100.0, 50.0, 25.0, 12.5, 8.0, 5.0, 3.5, 3.0};
    const auto directory = std::filesystem::absolute(settings.results) / "runs";
    for (const Method& method : methods) {
        Scene scene = narrow_scene(given);
        scene.integrator = method.integrator;
        for (const auto* code : adapters::select_codes(settings.codes)) {
            const auto* runner = dynamic_cast<const GrainCode*>(code);
            if (runner == nullptr || !code->probe().installed || runner->cannot_express(scene))
                continue;
            const StabilityTrial trial(*runner, directory, stop);
            for (const double steps : steps_in_contact_time) {
                if (stop.stop_requested()) return;
                add_residual(trial, scene, scene::contact_time(scene) / steps, report);
            }
            break;
        }
    }
}

}  // namespace

bool has_residuals(const catalog::Case& the_case, std::uint64_t seed) {
    return can_be_narrowed(the_case.grain_scene(0, 0, seed));
}

StabilityReport stability_dem(const catalog::Case& the_case, const run::Settings& settings,
                              store::Store& store, std::stop_token stop) {
    StabilityReport report{.case_name = the_case.name};
    const Scene given = the_case.grain_scene(0, 0, settings.seed);
    report.thresholds =
        find_thresholds(searches_for(given, settings), the_case.name, settings, store, stop);
    if (!settings.map_axes.empty()) return report;
    try {
        add_residuals(given, settings, stop, report);
    } catch (const Interrupted&) {
        // What has been found so far is reported.
    }
    return report;
}

std::vector<TheoryLine> theory_lines(const catalog::Case& map, std::uint64_t seed) {
    std::vector<TheoryLine> lines;
    std::set<std::string> seen;
    for (std::size_t v = 0; v < map.variants.size(); ++v) {
        TheoryLine line{.parameter = "dt", .source = lattice_theory};
        std::string others;
        for (const auto& [key, value] : map.variants[v].parameters) {
            if (key == line.parameter) continue;
            others += key + "=" + value + " ";
            char* end = nullptr;
            const double number = std::strtod(value.c_str(), &end);
            if (*end == '\0') {
                line.at[key] = number;
            } else {
                line.in[key] = value;
            }
        }
        if (!map.variants[v].parameter(line.parameter) || !seen.insert(others).second) continue;
        const Scene scene = map.grain_scene(v, 0, seed);
        const auto method = std::ranges::find(methods, scene.integrator, &Method::integrator);
        if (method == methods.end()) continue;
        line.limit = limit_in_lattice(scene, method->theory);
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace crossgrain::studies
