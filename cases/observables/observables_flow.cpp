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

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace crossgrain::observables {
namespace {

using catalog::ObservableRequest;
using scene::Scene;
using EstimatorPointer = std::unique_ptr<measure::Estimator>;

/// Overwrites a default with the option of that name, if it is given.
void read(const ObservableRequest& request, const char* name, double& value) {
    const auto found = request.options.find(name);
    if (found == request.options.end()) return;
    if (found->second.numbers.size() != 1) {
        throw std::invalid_argument(fmt::format("'{}' must be one number", name));
    }
    value = found->second.numbers.front();
}

void read(const ObservableRequest& request, const char* name, std::int64_t& value) {
    double number = static_cast<double>(value);
    read(request, name, number);
    if (number != std::round(number) || std::abs(number) > 1e9) {
        throw std::invalid_argument(fmt::format("'{}' must be a whole number", name));
    }
    value = static_cast<std::int64_t>(number);
}

void read(const ObservableRequest& request, measure::PipeRecordOptions& record) {
    read(request, "skip", record.skip);
    read(request, "bin", record.bin);
}

EstimatorPointer make_motion(const Scene& scene, const ObservableRequest& request) {
    measure::PipeMotionOptions o;
    read(request, o.record);
    read(request, "tolerance", o.tolerance);
    read(request, "sigmas", o.sigmas);
    return std::make_unique<measure::PipeMotion>(scene, o);
}

EstimatorPointer make_wave(const Scene& scene, const ObservableRequest& request) {
    measure::PipeWaveOptions o;
    read(request, o.record);
    read(request, "lag_min", o.overlap.lag_min);
    read(request, "lag_max", o.overlap.lag_max);
    read(request, "lag_step", o.overlap.lag_step);
    read(request, "smoothing", o.overlap.smoothing);
    read(request, "wavelength_min", o.wavelength_min);
    return std::make_unique<measure::PipeWave>(scene, o);
}

EstimatorPointer make_profile(const Scene& scene, const ObservableRequest& request) {
    measure::PipeProfileOptions o;
    read(request, o.record);
    return std::make_unique<measure::PipeProfile>(scene, o);
}

EstimatorPointer make_spectrum(const Scene& scene, const ObservableRequest& request) {
    measure::PipeSpectrumOptions o;
    read(request, o.record);
    read(request, "segments", o.segments);
    read(request, "low", o.low);
    read(request, "high", o.high);
    return std::make_unique<measure::PipeSpectrum>(scene, o);
}

EstimatorPointer make_structure(const Scene& scene, const ObservableRequest& request) {
    measure::PipeStructureOptions o;
    read(request, "skip", o.skip);
    read(request, "k_min", o.k_min);
    read(request, "k_max", o.k_max);
    return std::make_unique<measure::PipeStructure>(scene, o);
}

EstimatorPointer make_picture(const Scene& scene, const ObservableRequest& request) {
    measure::PipePictureOptions o;
    read(request, o.record);
    read(request, "rows", o.rows);
    return std::make_unique<measure::PipePicture>(scene, o);
}

EstimatorPointer make_rate(const Scene& scene, const ObservableRequest& request) {
    measure::DischargeRateOptions o;
    read(request, "from", o.from);
    read(request, "to", o.to);
    read(request, "down_to", o.down_to);
    return std::make_unique<measure::DischargeRate>(scene, o);
}

EstimatorPointer make_stagnation(const Scene& scene, const ObservableRequest& request) {
    measure::DischargeStagnationOptions o;
    read(request, "from", o.from);
    read(request, "to", o.to);
    read(request, "bin", o.bin);
    if (const auto shares = request.options.find("shares"); shares != request.options.end()) {
        o.shares = shares->second.numbers;
    }
    return std::make_unique<measure::DischargeStagnation>(scene, o);
}

}  // namespace

const std::vector<GrainObservable>& flow_observables() {
    static const std::vector<GrainObservable> all{
        {"pipe-motion",
         "pipe",
         "mean_speed, flux (phi V), area_fraction, granular_temperature, mean_square_spin, "
         "drift_speed, drift_temperature, drift_variance; state (steady, ageing); V(t), T(t)",
         {"skip", "bin", "tolerance", "sigmas"},
         make_motion},
        {"pipe-wave",
         "pipe",
         "overlap_velocity, wave_velocity (peak), flux_slope (dJ/drho), wave_over_speed, "
         "wave_over_flux_slope, overlap_wave_fraction; wave (wave, carried, none); J(phi)",
         {"skip", "bin", "lag_min", "lag_max", "lag_step", "smoothing", "wavelength_min"},
         make_wave},
        {"pipe-profile",
         "pipe",
         "profile_amplitude, profile_null_amplitude, profile_excess, profile_asymmetry, "
         "profile_front_sharper; density around the crest of the wave",
         {"skip", "bin"},
         make_profile},
        {"pipe-spectrum",
         "pipe",
         "alpha in the window from the wave to single grains; spectrum of the bin densities",
         {"skip", "bin", "segments", "low", "high"},
         make_spectrum},
        {"pipe-structure",
         "pipe",
         "wave_number_exponent, structure_factor, wave_number; S(k)",
         {"skip", "k_min", "k_max"},
         make_structure},
        {"pipe-picture",
         "pipe",
         "density of grains in space and time, in grey",
         {"skip", "bin", "rows"},
         make_picture},
        {"discharge-rate",
         "discharge",
         "flow_rate, flow_rate_drift, flow_rate_halves, flow_exponent; flow (steady, changing, "
         "jammed); mass and rate against time and filling height",
         {"from", "to", "down_to"},
         make_rate},
        {"discharge-stagnation",
         "discharge",
         "moving_fraction_<eps> (P_eps); state (mass flow, funnel flow); velocity along the walls",
         {"from", "to", "bin", "shares"},
         make_stagnation},
    };
    return all;
}

}  // namespace crossgrain::observables
