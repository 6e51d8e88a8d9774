#include "reference/analytic/normal_collision.hpp"

#include "reference/analytic/parameter_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::analytic {
namespace {

// First zero of delta'', t_f. With s = omega^2 of either sign the three regimes are branches of one
// function; near s = 0 both branches lose digits, so its series takes over:
// t_f = (2/gamma) (1 - x/3 + x^2/5 - x^3/7 ...), x = s/gamma^2, since t_f = 2
// atan(omega/gamma)/omega (underdamped, gamma > 0) and 2 atanh(beta/gamma)/beta (overdamped).
double force_end(double gamma, double omega_squared) {
    if (gamma == 0) return std::numbers::pi / std::sqrt(omega_squared);
    const double x = omega_squared / (gamma * gamma);
    if (std::abs(x) < 1e-4) return 2 / gamma * (1 - x * (1.0 / 3 - x * (1.0 / 5 - x / 7)));
    if (x > 0) {
        const double omega = std::sqrt(omega_squared);
        return 2 * std::atan2(omega, gamma) / omega;
    }
    const double ratio = std::sqrt(-x);  // beta/gamma
    return 2 * std::atanh(ratio) / (ratio * gamma);
}

}  // namespace

double reduced_mass(double m1, double m2) {
    if (!(m1 > 0) || !(m2 > 0) || (std::isinf(m1) && std::isinf(m2))) {
        throw std::domain_error(
            fmt::format("masses must be > 0 and one of them finite, got {} and {}", m1, m2));
    }
    return 1 / (1 / m1 + 1 / m2);
}

NormalCollision normal_collision(const NormalContact& contact, Attraction attraction) {
    require_positive("stiffness", contact.stiffness);
    require_not_negative("damping", contact.damping);
    require_positive("reduced mass", contact.reduced_mass);
    const double gamma = contact.damping / (2 * contact.reduced_mass);
    const double omega_squared = contact.stiffness / contact.reduced_mass - gamma * gamma;
    if (attraction == Attraction::cut) {
        const double t_f = force_end(gamma, omega_squared);
        return {.restitution = std::exp(-gamma * t_f),
                .force_time = t_f,
                .contact_time = t_f + contact.damping / contact.stiffness};
    }
    if (omega_squared <= 0) {
        throw std::domain_error(fmt::format(
            "a contact with k = {}, eta = {}, reduced mass {} is not underdamped: with attraction "
            "the bodies never part, there is no restitution and no contact time",
            contact.stiffness, contact.damping, contact.reduced_mass));
    }
    const double t_c = std::numbers::pi / std::sqrt(omega_squared);
    return {.restitution = std::exp(-gamma * t_c), .force_time = t_c, .contact_time = t_c};
}

NormalContact contact_from(double restitution, double contact_time, double reduced_mass) {
    require_positive("contact time", contact_time);
    require_positive("reduced mass", reduced_mass);
    if (!(restitution > 0) || !(restitution <= 1)) {
        throw std::domain_error(fmt::format("restitution must be in (0, 1], got {}", restitution));
    }
    const double gamma = -std::log(restitution) / contact_time;
    const double omega = std::numbers::pi / contact_time;
    return {.stiffness = reduced_mass * (omega * omega + gamma * gamma),
            .damping = 2 * reduced_mass * gamma,
            .reduced_mass = reduced_mass};
}

}  // namespace crossgrain::analytic
