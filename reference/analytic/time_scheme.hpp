// The integration schemes that closed forms know.
#pragma once

namespace crossgrain::analytic {

enum class TimeScheme {
    half_step_verlet,
    predicted_verlet,
    crank_nicolson_leapfrog,
    semi_implicit_euler,
    explicit_euler,
    taguchi_euler,
    runge_kutta_4
};

}  // namespace crossgrain::analytic
