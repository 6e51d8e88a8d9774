#include "cases/scene/gas_sampling_json.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::scene {

nlohmann::json to_json(const GasSampling& s) {
    return {
        {"length", s.length},
        {"width", s.width},
        {"periodic", s.periodic},
        {"bin", s.bin},
        {"replicas", s.replicas},
        {"burn_in", s.burn_in},
        {"steps", s.steps},
        {"every", s.every},
        {"fields",
         {{"count", s.fields.count}, {"rests", s.fields.rests}, {"momentum", s.fields.momentum}}}};
}

}  // namespace crossgrain::scene
