#include "adapters/program/native_choice.hpp"

namespace crossgrain::adapters {

std::optional<std::string> native_choice(const scene::Scene& scene) {
    if (scene.contacts != scene::Contacts::neighbour_list) {
        return "whatever comes near touches: contacts cannot be limited to fixed lattice "
               "neighbours (contacts neighbour-list would be expressible)";
    }
    if (scene.precision != scene::Precision::double_precision) {
        return "positions and velocities are double (precision double would be expressible)";
    }
    return std::nullopt;
}

}  // namespace crossgrain::adapters
