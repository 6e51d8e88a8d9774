// The observables of grains that flow: through a pipe and out of a hopper.
#include "cases/observables/model_observables.hpp"

#include "cases/measure/discharge/discharge_rate.hpp"
#include "cases/measure/discharge/discharge_stagnation.hpp"
#include "cases/measure/pipe/pipe_motion.hpp"
#include "cases/measure/pipe/pipe_picture.hpp"
#include "cases/measure/pipe/pipe_profile.hpp"
#include "cases/measure/pipe/pipe_spectrum.hpp"
#include "cases/measure/pipe/pipe_structure.hpp"
#include "cases/measure/pipe/pipe_wave.hpp"

namespace crossgrain::observables {

const std::vector<GrainObservable>& flow_observables() {
    static const std::vector<GrainObservable> all{
        GrainObservable::of<measure::PipeMotion>(
            "pipe-motion", "pipe",
            "mean_speed, flux (phi V), area_fraction, granular_temperature, mean_square_spin, "
            "drift_speed, drift_temperature, drift_variance; state (steady, ageing); V(t), T(t)"),
        GrainObservable::of<measure::PipeWave>(
            "pipe-wave", "pipe",
            "overlap_velocity, wave_velocity (peak), flux_slope (dJ/drho), wave_over_speed, "
            "wave_over_flux_slope, overlap_wave_fraction; wave (wave, carried, none); J(phi)"),
        GrainObservable::of<measure::PipeProfile>(
            "pipe-profile", "pipe",
            "profile_amplitude, profile_null_amplitude, profile_excess, profile_asymmetry, "
            "profile_front_sharper; density around the crest of the wave"),
        GrainObservable::of<measure::PipeSpectrum>(
            "pipe-spectrum", "pipe",
            "alpha in the window from the wave to single grains; spectrum of the bin densities"),
        GrainObservable::of<measure::PipeStructure>(
            "pipe-structure", "pipe", "wave_number_exponent, structure_factor, wave_number; S(k)"),
        GrainObservable::of<measure::PipePicture>("pipe-picture", "pipe",
                                                  "density of grains in space and time, in grey"),
        GrainObservable::of<measure::DischargeRate>(
            "discharge-rate", "discharge",
            "flow_rate, flow_rate_drift, flow_rate_halves, flow_exponent; flow (steady, changing, "
            "jammed); mass and rate against time and filling height"),
        GrainObservable::of<measure::DischargeStagnation>(
            "discharge-stagnation", "discharge",
            "moving_fraction_<eps> (P_eps); state (mass flow, funnel flow); velocity along the "
            "walls"),
    };
    return all;
}

}  // namespace crossgrain::observables
