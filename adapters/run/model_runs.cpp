#include "adapters/run/model_runs.hpp"

namespace crossgrain::run {

bool runs_model(const adapters::Code& code, const std::string& model) {
    if (model == "lattice-gas") return dynamic_cast<const adapters::GasCode*>(&code) != nullptr;
    if (model == "hopper-automaton") {
        return dynamic_cast<const adapters::HopperCode*>(&code) != nullptr;
    }
    if (model == "synthetic-signal") {
        return dynamic_cast<const adapters::SignalCode*>(&code) != nullptr;
    }
    return dynamic_cast<const adapters::GrainCode*>(&code) != nullptr;
}

std::optional<std::string> cannot_express(const adapters::Code& code,
                                          const scene::AnyScene& scene) {
    return with_code(code, scene, [](const auto& c, const auto& s) { return c.cannot_express(s); });
}

std::vector<adapters::InputFile> input_of(const adapters::Code& code,
                                          const scene::AnyScene& scene) {
    return with_code(code, scene, [](const auto& c, const auto& s) { return c.input(s); });
}

double progress_of(const scene::Scene& scene, const scene::Frame& frame) {
    return static_cast<double>(frame.step) / static_cast<double>(scene.steps);
}

double progress_of(const scene::LatticeGas& scene, const scene::GasFrame& frame) {
    return static_cast<double>(frame.step) /
           static_cast<double>(scene.sampling.burn_in + scene.sampling.steps);
}

double progress_of(const scene::SyntheticSignal& scene, const scene::GasFrame& frame) {
    return static_cast<double>(frame.step) /
           static_cast<double>(scene.sampling.burn_in + scene.sampling.steps);
}

double progress_of(const scene::HopperAutomaton& scene, const scene::HopperFrame& frame) {
    const auto replicas = static_cast<double>(scene.replicas);
    const double done =
        static_cast<double>(frame.angle_index) * replicas + frame.replica +
        static_cast<double>(frame.iteration) / static_cast<double>(scene.iterations);
    return done / (static_cast<double>(scene.angles.size()) * replicas);
}

}  // namespace crossgrain::run
