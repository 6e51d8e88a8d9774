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

#include <cmath>
#include <stdexcept>

namespace crossgrain::observables {
namespace {

using catalog::ObservableRequest;
using scene::GasSampling;
using GasEstimatorPointer = std::unique_ptr<measure::GasEstimator>;

/// The options of one request, read over an estimator's defaults.
class Options {
  public:
    explicit Options(const ObservableRequest& request) : request_(request) {}

    void read(const char* name, double& value) const {
        if (const auto given = number(name)) value = *given;
    }
    void read(const char* name, std::int64_t& value) const {
        const auto given = number(name);
        if (!given) return;
        if (*given != std::round(*given) || std::abs(*given) > 1e9) {
            throw std::invalid_argument(std::string(name) + " must be a whole number, at most 1e9");
        }
        value = static_cast<std::int64_t>(*given);
    }

  private:
    [[nodiscard]] std::optional<double> number(const char* name) const {
        const auto found = request_.options.find(name);
        if (found == request_.options.end()) return std::nullopt;
        if (found->second.numbers.size() != 1) {
            throw std::invalid_argument(std::string(name) + " must be one number");
        }
        return found->second.numbers.front();
    }

    const ObservableRequest& request_;
};

GasEstimatorPointer make_spectrum(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasSpectrumOptions o;
    const Options given(request);
    given.read("segments", o.segments);
    given.read("points", o.points);
    given.read("f_min", o.f_min);
    given.read("f_max", o.f_max);
    given.read("v_min", o.v_min);
    given.read("v_max", o.v_max);
    given.read("running_mean", o.running_mean);
    given.read("first_bin", o.first_bin);
    given.read("last_bin", o.last_bin);
    return std::make_unique<measure::GasSpectrum>(sampling, o);
}

GasEstimatorPointer make_correlation(const GasSampling& sampling,
                                     const ObservableRequest& request) {
    measure::GasCorrelationOptions o;
    const Options given(request);
    given.read("separation", o.separation);
    given.read("v_min", o.v_min);
    given.read("v_max", o.v_max);
    given.read("running_mean", o.running_mean);
    given.read("references", o.references);
    return std::make_unique<measure::GasCorrelation>(sampling, o);
}

GasEstimatorPointer make_wave_number(const GasSampling& sampling,
                                     const ObservableRequest& request) {
    measure::GasWaveNumberOptions o;
    const Options given(request);
    given.read("k_min", o.k_min);
    given.read("k_max", o.k_max);
    given.read("fields", o.fields);
    return std::make_unique<measure::GasWaveNumber>(sampling, o);
}

GasEstimatorPointer make_steady_state(const GasSampling& sampling,
                                      const ObservableRequest& request) {
    measure::GasSteadyStateOptions o;
    const Options given(request);
    given.read("tolerance", o.tolerance);
    given.read("sigmas", o.sigmas);
    return std::make_unique<measure::GasSteadyState>(sampling, o);
}

template <class Estimator>
GasEstimatorPointer make_plain(const GasSampling& sampling, const ObservableRequest& /*none*/) {
    return std::make_unique<Estimator>(sampling);
}

GasEstimatorPointer make_flux(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasFluxOptions o;
    Options(request).read("window", o.window);
    return std::make_unique<measure::GasFlux>(sampling, o);
}

GasEstimatorPointer make_overlap(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasOverlapOptions o;
    const Options given(request);
    given.read("lag_min", o.lag_min);
    given.read("lag_max", o.lag_max);
    given.read("lag_step", o.lag_step);
    given.read("smoothing", o.smoothing);
    given.read("v_min", o.v_min);
    given.read("v_max", o.v_max);
    given.read("references", o.references);
    return std::make_unique<measure::GasOverlap>(sampling, o);
}

GasEstimatorPointer make_picture(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasPictureOptions o;
    const Options given(request);
    given.read("replica", o.replica);
    given.read("rows", o.rows);
    return std::make_unique<measure::GasPicture>(sampling, o);
}

GasEstimatorPointer make_profile(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasProfileOptions o;
    const Options given(request);
    given.read("fields", o.fields);
    given.read("groups", o.groups);
    return std::make_unique<measure::GasProfile>(sampling, o);
}

GasEstimatorPointer make_total(const GasSampling& sampling, const ObservableRequest& request) {
    measure::GasTotalOptions o;
    Options(request).read("margin", o.margin);
    return std::make_unique<measure::GasTotal>(sampling, o);
}

}  // namespace

const std::vector<GasObservable>& gas_observables() {
    static const std::vector<GasObservable> all{
        {"gas-spectrum",
         "gas",
         "alpha, wave_velocity (peak), wave_fraction; power spectrum of the bin densities",
         {"segments", "points", "f_min", "f_max", "v_min", "v_max", "running_mean", "first_bin",
          "last_bin"},
         make_spectrum},
        {"gas-correlation",
         "gas",
         "correlation_time, correlation_velocity; C(R, T)",
         {"separation", "v_min", "v_max", "running_mean", "references"},
         make_correlation},
        {"gas-wave-number",
         "gas",
         "wave_number_exponent, wave_number; spatial spectrum S(k)",
         {"k_min", "k_max", "fields"},
         make_wave_number},
        {"gas-steady-state",
         "gas",
         "state (steady, ageing, absorbing, clogged, saturated); drift_rests, drift_contrast, "
         "drift_variance, drift_particles, absorbing_fraction, saturated_fraction",
         {"tolerance", "sigmas"},
         make_steady_state},
        {"gas-bin-lag",
         "gas",
         "bin_lag_variance: whether all bins of a frame show the same instant",
         {},
         make_plain<measure::GasBinLag>},
        {"gas-contrast",
         "gas",
         "contrast_late, contrast_growth, contrast_grows, contrast_excess; C(t) beside white noise",
         {},
         make_plain<measure::GasContrast>},
        {"gas-energy",
         "gas",
         "rests_per_site, energy_loss_late, energy_loss_drift, energy_loss_saturates, "
         "energy_saturation_time; E(0) - E(t)",
         {},
         make_plain<measure::GasEnergy>},
        {"gas-flux",
         "gas",
         "flux, mean_speed, particles_per_site, flux_slope; J(rho)",
         {"window"},
         make_flux},
        {"gas-overlap",
         "gas",
         "overlap_velocity, overlap_wave_fraction, overlap_other_fraction; shift against interval",
         {"lag_min", "lag_max", "lag_step", "smoothing", "v_min", "v_max", "references"},
         make_overlap},
        {"gas-picture",
         "gas",
         "density in space and time, in grey",
         {"replica", "rows"},
         make_picture},
        {"gas-profile",
         "gas",
         "profile_amplitude, profile_null_amplitude, profile_excess, profile_width, "
         "profile_width_over_length, profile_asymmetry, profile_front_sharper; density around the "
         "peak",
         {"fields", "groups"},
         make_profile},
        {"gas-total",
         "gas",
         "number_plateau, number_late, number_growth, clogged_fraction, outflow; N(t)",
         {"margin"},
         make_total},
    };
    return all;
}

}  // namespace crossgrain::observables
