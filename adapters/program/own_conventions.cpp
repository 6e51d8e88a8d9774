#include "adapters/program/own_conventions.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

bool same_force(const scene::Friction& friction, const scene::FrictionConventions& a,
                const scene::FrictionConventions& b) {
    if (a.velocity_lever != b.velocity_lever || a.torque_lever != b.torque_lever) return false;
    if (friction.force == scene::TangentialForce::dashpot) return true;
    return a.rotation == b.rotation && (friction.damping == 0 || a.limit == b.limit);
}

std::optional<std::string> foreign_conventions(const scene::Scene& scene, const std::string& own) {
    if (!scene.has_friction() || !scene.contact.friction->conventions) return std::nullopt;
    const auto& friction = *scene.contact.friction;
    const auto& asked = *friction.conventions;
    if (same_force(friction, asked, scene::conventions_named(own).value())) return std::nullopt;
    return fmt::format("a frictional contact is followed from step to step as \"{0}\" says, not as "
                       "in {1} (conventions {0} or own would be expressible)",
                       own, to_string(asked));
}

}  // namespace crossgrain::adapters
