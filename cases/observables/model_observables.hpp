// Observables of every model, as the one catalogue of the app holds them.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/measure/estimator.hpp"
#include "cases/observables/option_reading.hpp"
#include "cases/scene/any_scene.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::observables {

/// `SubjectT` is what the estimator has to know of the scene.
template <class SubjectT, class FrameT>
struct ModelObservable {
    using Subject = SubjectT;
    using Frame = FrameT;
    using Make = std::unique_ptr<measure::EstimatorOf<FrameT>>(const SubjectT&,
                                                               const std::string& file,
                                                               const catalog::ObservableRequest&);

    std::string name;
    std::string folder;                    ///< of the estimator, below cases/measure
    std::string measures;                  ///< measurements, series, pictures, findings, in words
    std::vector<toml_input::Key> options;  ///< of [[observable]] in a case file
    /// Throws CaseError, with its place in `file`, for what is wrong with an option, and
    /// std::invalid_argument for a scene that cannot be measured.
    std::function<Make> make;

    /// One that `E` measures. Its options are E::Options, if it has any.
    template <class E>
    static ModelObservable of(std::string name, std::string folder, std::string measures) {
        ModelObservable one{std::move(name), std::move(folder), std::move(measures), {}, {}};
        if constexpr (requires { typename E::Options; }) {
            typename E::Options standard;
            one.options = table_keys(option_keys(standard));
            one.make = [](const SubjectT& subject, const std::string& file,
                          const catalog::ObservableRequest& request) {
                typename E::Options options;
                read_options(file, request, option_keys(options));
                return std::make_unique<E>(subject, std::move(options));
            };
        } else {
            one.make = [](const SubjectT& subject, const std::string& file,
                          const catalog::ObservableRequest& request) {
                read_options(file, request, {});
                return std::make_unique<E>(subject);
            };
        }
        return one;
    }
};

using GrainObservable = ModelObservable<scene::Scene, scene::Frame>;
using GasObservable = ModelObservable<scene::GasSampling, scene::GasFrame>;
using HopperObservable = ModelObservable<scene::HopperAutomaton, scene::HopperFrame>;

[[nodiscard]] const std::vector<GrainObservable>& grain_observables();
/// Those of grains in pipes and hoppers, which grain_observables() holds too.
[[nodiscard]] const std::vector<GrainObservable>& flow_observables();
[[nodiscard]] const std::vector<GasObservable>& gas_observables();
[[nodiscard]] const std::vector<HopperObservable>& hopper_observables();

/// The observables of a scene's model, and what they have to know of it.
[[nodiscard]] inline const std::vector<GrainObservable>&
observables_of(const scene::Scene& /*model*/) {
    return grain_observables();
}
[[nodiscard]] inline const std::vector<GasObservable>&
observables_of(const scene::LatticeGas& /*model*/) {
    return gas_observables();
}
[[nodiscard]] inline const std::vector<GasObservable>&
observables_of(const scene::SyntheticSignal& /*model*/) {
    return gas_observables();
}
[[nodiscard]] inline const std::vector<HopperObservable>&
observables_of(const scene::HopperAutomaton& /*model*/) {
    return hopper_observables();
}

[[nodiscard]] inline const scene::Scene& subject_of(const scene::Scene& scene) {
    return scene;
}
[[nodiscard]] inline const scene::GasSampling& subject_of(const scene::LatticeGas& scene) {
    return scene.sampling;
}
[[nodiscard]] inline const scene::GasSampling& subject_of(const scene::SyntheticSignal& scene) {
    return scene.sampling;
}
[[nodiscard]] inline const scene::HopperAutomaton& subject_of(const scene::HopperAutomaton& scene) {
    return scene;
}

}  // namespace crossgrain::observables
