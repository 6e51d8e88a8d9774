#include "cases/scene/gas_sampling_json.hpp"
#include "cases/scene/model_json.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::scene {
namespace {

nlohmann::json parameters_json(const SyntheticSignal& signal) {
    nlohmann::json result{
        {"mean", signal.mean}, {"noise", signal.noise}, {"exponent", signal.exponent}};
    if (signal.wave_amplitude > 0) {
        result["wave_amplitude"] = signal.wave_amplitude;
        result["wave_velocity"] = signal.wave_velocity;
        result["wave_number"] = signal.wave_number;
    }
    return result;
}

}  // namespace

nlohmann::json to_json(const SyntheticSignal& signal) {
    nlohmann::json result = parameters_json(signal);
    result["model"] = "synthetic-signal";
    result["name"] = signal.name;
    result["sampling"] = signal.sampling;
    result["seed"] = signal.seed;
    return result;
}

nlohmann::json settings_json(const SyntheticSignal& signal) {
    nlohmann::json result = parameters_json(signal);
    result["length"] = signal.sampling.length;
    result["bin"] = signal.sampling.bin;
    result["gas_replicas"] = signal.sampling.replicas;
    result["steps"] = signal.sampling.steps;
    result["every"] = signal.sampling.every;
    return result;
}

}  // namespace crossgrain::scene
