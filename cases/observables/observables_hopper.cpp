// The observables of the hopper automaton.
#include "cases/observables/model_observables.hpp"

#include "cases/measure/hopper/hopper_damage.hpp"
#include "cases/measure/hopper/hopper_flow.hpp"
#include "cases/measure/hopper/hopper_pattern.hpp"
#include "cases/measure/hopper/hopper_picture.hpp"
#include "cases/measure/hopper/hopper_stagnation.hpp"
#include "cases/measure/hopper/hopper_surface.hpp"

namespace crossgrain::observables {

const std::vector<HopperObservable>& hopper_observables() {
    static const std::vector<HopperObservable> all{
        HopperObservable::of<measure::HopperStagnation>(
            "hopper-stagnation", "hopper",
            "moving_fraction (P), exponent_..., critical_angle...; P(theta) and its fits, the "
            "wall's profile"),
        HopperObservable::of<measure::HopperFlow>(
            "hopper-flow", "hopper",
            "flow_rate, flow_exponent, filling_at_first_loss, residue; rate and filling against "
            "iterations"),
        HopperObservable::of<measure::HopperSurface>(
            "hopper-surface", "hopper",
            "crater_depth, crater_half_width, surface_slope, surface_slope_steepest, "
            "surface_scatter; the profile"),
        HopperObservable::of<measure::HopperPattern>(
            "hopper-pattern", "hopper",
            "neighbour_correlation, correlation_length_x and _y, vertical_fraction, "
            "pattern_velocity..., asymmetry, mirror_imbalance_sites and _grains; state"),
        HopperObservable::of<measure::HopperDamage>(
            "hopper-damage", "hopper",
            "damage, damaged_trials, shape_difference of twins; damage against iterations"),
        HopperObservable::of<measure::HopperPicture>("hopper-picture", "hopper",
                                                     "the orientations and the free surface"),
    };
    return all;
}

}  // namespace crossgrain::observables
