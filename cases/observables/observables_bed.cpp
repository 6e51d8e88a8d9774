// The observables of beds and collisions.
#include "cases/observables/model_observables.hpp"

#include "cases/measure/bed/displacement_spectrum.hpp"
#include "cases/measure/bed/energy_balance.hpp"
#include "cases/measure/bed/flow_depth.hpp"
#include "cases/measure/bed/lattice_order.hpp"
#include "cases/measure/bed/lid_height.hpp"
#include "cases/measure/bed/velocity_spectrum.hpp"
#include "cases/measure/collision/momentum.hpp"
#include "cases/measure/collision/pair_collision.hpp"
#include "cases/measure/collision/plate_bounce.hpp"
#include "cases/measure/collision/trajectory.hpp"

namespace crossgrain::observables {

const std::vector<GrainObservable>& grain_observables() {
    static const std::vector<GrainObservable> all = [] {
        std::vector<GrainObservable> entries{
            GrainObservable::of<measure::PairCollision>(
                "pair-collision", "collision",
                "restitution, contact_time, speed_ratio, angular_momentum_ratio of isolated pairs"),
            GrainObservable::of<measure::PlateBounce>(
                "plate-bounce", "collision",
                "plate_restitution, plate_contact_time, plate_momentum_error of isolated grains"),
            GrainObservable::of<measure::Trajectory>(
                "trajectory", "collision", "positions at given times, compared between codes"),
            GrainObservable::of<measure::Momentum>("momentum", "collision",
                                                   "momentum_drift_x, momentum_drift_y"),
            GrainObservable::of<measure::EnergyBalance>(
                "energy-balance", "bed",
                "energy_residual, mean_energy, mean_energy_input, mean_dissipation, "
                "energy_above_ground, input_per_period, energy_per_input; energies against time"),
            GrainObservable::of<measure::LidHeight>("lid-height", "bed",
                                                    "mean_lid_height; h(t), bottom and spacing"),
            GrainObservable::of<measure::DisplacementSpectrum>(
                "displacement-spectrum", "bed",
                "S(K, Y) by groups of layers, slope_..., slope_tail_..., displacement_vectors, the "
                "last vector of every grain"),
            GrainObservable::of<measure::VelocitySpectrum>(
                "velocity-spectrum", "bed",
                "E(K, t) of a lattice at times, phases or over a window: velocity_slope_..., "
                "transverse_energy_...; slopes against time"),
            GrainObservable::of<measure::LatticeOrder>(
                "lattice-order", "bed",
                "foreign_contacts, lattice_kept_until: whether rows slid through each other"),
            GrainObservable::of<measure::FlowDepth>(
                "flow-depth", "bed",
                "flow_depth, flowing_layers, lost_bonds of a vibrated bed; lost bonds by layer"),
            // tools/new.sh observable: entries go above this line
        };
        const auto& flow = flow_observables();
        entries.insert(entries.end(), flow.begin(), flow.end());
        return entries;
    }();
    return all;
}

}  // namespace crossgrain::observables
