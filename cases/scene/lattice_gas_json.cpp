#include "cases/scene/collision_notation.hpp"
#include "cases/scene/gas_sampling_json.hpp"
#include "cases/scene/model_json.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::scene {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GravityRule, rest_to_down, up_diagonals, up_to_rest, on_walls)

namespace {

using nlohmann::json;

/// What the rules are, not what they are called.
json reading_json(const GasReading& reading) {
    json rows = json::array();
    for (const CollisionRow& row : reading.rows) {
        rows.push_back({{"from", to_string(row.before)},
                        {"to", to_string(row.after)},
                        {"matching", to_string(row.matching)},
                        {"probability", {row.probability.constant, row.probability.p_factor}}});
    }
    return {{"rows", rows},
            {"gravity", reading.gravity},
            {"walls", to_string(reading.walls)},
            {"relocation", to_string(reading.relocation)}};
}

json parameters_json(const LatticeGas& gas) {
    json result{{"ends", to_string(gas.ends)},     {"dissipation", gas.dissipation},
                {"gravity", gas.gravity},          {"roughness", gas.roughness},
                {"engine", to_string(gas.engine)}, {"on_saturation", to_string(gas.on_saturation)}};
    if (gas.word_bits) result["word_bits"] = *gas.word_bits;
    if (gas.ends == PipeEnds::periodic) {
        result["density"] = gas.density;
    } else {
        result["injection"] = gas.injection;
    }
    return result;
}

}  // namespace

json to_json(const LatticeGas& gas) {
    json result = parameters_json(gas);
    result["model"] = "lattice-gas";
    result["name"] = gas.name;
    result["reading"] = reading_json(gas.reading);
    result["sampling"] = gas.sampling;
    result["seed"] = gas.seed;
    return result;
}

json settings_json(const LatticeGas& gas) {
    json result = parameters_json(gas);
    const GasSampling& s = gas.sampling;
    result["reading"] = gas.reading.name;
    result["length"] = s.length;
    result["width"] = s.width;
    result["bin"] = s.bin;
    result["gas_replicas"] = s.replicas;
    result["burn_in"] = s.burn_in;
    result["steps"] = s.steps;
    result["every"] = s.every;
    return result;
}

}  // namespace crossgrain::scene
