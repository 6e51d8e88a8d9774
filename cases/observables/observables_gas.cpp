#include "cases/observables/model_observables.hpp"

#include "cases/measure/gas/gas_bin_lag.hpp"
#include "cases/measure/gas/gas_contrast.hpp"
#include "cases/measure/gas/gas_correlation.hpp"
#include "cases/measure/gas/gas_energy.hpp"
#include "cases/measure/gas/gas_flux.hpp"
#include "cases/measure/gas/gas_overlap.hpp"
#include "cases/measure/gas/gas_picture.hpp"
#include "cases/measure/gas/gas_profile.hpp"
#include "cases/measure/gas/gas_spectrum.hpp"
#include "cases/measure/gas/gas_steady_state.hpp"
#include "cases/measure/gas/gas_total.hpp"
#include "cases/measure/gas/gas_wave_number.hpp"

namespace crossgrain::observables {

const std::vector<GasObservable>& gas_observables() {
    static const std::vector<GasObservable> all{
        GasObservable::of<measure::GasSpectrum>(
            "gas-spectrum", "gas",
            "alpha, wave_velocity (peak), wave_fraction; power spectrum of the bin densities"),
        GasObservable::of<measure::GasCorrelation>(
            "gas-correlation", "gas", "correlation_time, correlation_velocity; C(R, T)"),
        GasObservable::of<measure::GasWaveNumber>(
            "gas-wave-number", "gas", "wave_number_exponent, wave_number; spatial spectrum S(k)"),
        GasObservable::of<measure::GasSteadyState>(
            "gas-steady-state", "gas",
            "state (steady, ageing, absorbing, clogged, saturated); drift_rests, drift_contrast, "
            "drift_variance, drift_particles, absorbing_fraction, saturated_fraction"),
        GasObservable::of<measure::GasBinLag>(
            "gas-bin-lag", "gas",
            "bin_lag_variance: whether all bins of a frame show the same instant"),
        GasObservable::of<measure::GasContrast>("gas-contrast", "gas",
                                                "contrast_late, contrast_growth, contrast_grows, "
                                                "contrast_excess; C(t) beside white noise"),
        GasObservable::of<measure::GasEnergy>(
            "gas-energy", "gas",
            "rests_per_site, energy_loss_late, energy_loss_drift, energy_loss_saturates, "
            "energy_saturation_time; E(0) - E(t)"),
        GasObservable::of<measure::GasFlux>(
            "gas-flux", "gas", "flux, mean_speed, particles_per_site, flux_slope; J(rho)"),
        GasObservable::of<measure::GasOverlap>("gas-overlap", "gas",
                                               "overlap_velocity, overlap_wave_fraction, "
                                               "overlap_other_fraction; shift against interval"),
        GasObservable::of<measure::GasPicture>("gas-picture", "gas",
                                               "density in space and time, in grey"),
        GasObservable::of<measure::GasProfile>(
            "gas-profile", "gas",
            "profile_amplitude, profile_null_amplitude, profile_excess, profile_width, "
            "profile_width_over_length, profile_asymmetry, profile_front_sharper; density around "
            "the peak"),
        GasObservable::of<measure::GasTotal>(
            "gas-total", "gas",
            "number_plateau, number_late, number_growth, clogged_fraction, outflow; N(t)"),
    };
    return all;
}

}  // namespace crossgrain::observables
