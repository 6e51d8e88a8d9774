#include "cases/measure/gas/gas_flux.hpp"

#include "cases/measure/waves/over_samples.hpp"
#include "native/base/memory_budget.hpp"
#include "native/numerics/line_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double classes_per_unit = 40;

// Seven states per site, and two more in each wall site beside the bin.
std::size_t most_particles(const scene::GasSampling& sampling) {
    const std::size_t most =
        static_cast<std::size_t>(sampling.bin) * (7 * static_cast<std::size_t>(sampling.width) + 4);
    require_memory(16.0 * static_cast<double>(most) * sampling.replicas,
                   "sums for every number of particles in a bin");
    return most;
}

}  // namespace

GasFlux::GasFlux(const scene::GasSampling& sampling, GasFluxOptions options)
    : sampling_(sampling), options_(options),
      replicas_(static_cast<std::size_t>(sampling.replicas)),
      densities_(most_particles(sampling) + 1), seen_(replicas_ * densities_, 0),
      momentum_(replicas_ * densities_, 0) {
    if (!sampling.fields.count || !sampling.fields.momentum) {
        throw std::invalid_argument("the flux needs the fields 'count' and 'momentum'");
    }
    if (!(options.window > 0 && options.window <= 1)) {
        throw std::invalid_argument(
            fmt::format("window must be in (0, 1], not {}", options.window));
    }
}

void GasFlux::add(const scene::GasFrame& frame) {
    for (std::size_t bin = 0; bin < frame.bins; ++bin) {
        for (std::size_t r = 0; r < frame.replicas; ++r) {
            const std::size_t from = bin * frame.replicas + r;
            const std::size_t at = r * densities_ + frame.count[from];
            ++seen_[at];
            momentum_[at] += frame.momentum[from];
        }
    }
}

std::vector<double> GasFlux::slopes() const {
    std::vector<double> slopes;
    for (std::size_t r = 0; r < replicas_; ++r) {
        const auto* seen = &seen_[r * densities_];
        const auto* momentum = &momentum_[r * densities_];
        double all = 0, particles = 0;
        for (std::size_t n = 0; n < densities_; ++n) {
            all += static_cast<double>(seen[n]);
            particles += static_cast<double>(seen[n]) * static_cast<double>(n);
        }
        if (all == 0) continue;
        const double mean = particles / all;
        // A class weighs as much as it has been seen; x and y are its density and its mean flux.
        std::vector<double> x, y, errors;
        for (std::size_t n = 0; n < densities_; ++n) {
            const double away = static_cast<double>(n) - mean;
            if (seen[n] == 0 || std::abs(away) > options_.window * mean) continue;
            const auto weight = static_cast<double>(seen[n]);
            x.push_back(away);
            y.push_back(static_cast<double>(momentum[n]) / 2 / weight);
            errors.push_back(1 / std::sqrt(weight));
        }
        if (x.size() >= 2) slopes.push_back(numerics::fit_line(x, y, errors).slope);
    }
    return slopes;
}

// The ratio (summed flux)/(bins seen) of a class, its error from the replicas' residuals.
Series GasFlux::curve() const {
    const double sites = static_cast<double>(sampling_.bin) * sampling_.width;
    const auto step = static_cast<std::size_t>(std::max(1.0, std::round(sites / classes_per_unit)));
    double all = 0;
    for (const std::int64_t seen : seen_)
        all += static_cast<double>(seen);
    Series series{.name = "flux",
                  .columns = {"rho", "J", "err", "share"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"1/site", "1/step", "1/step", "1"}};
    std::vector<double> seen(replicas_), flux(replicas_);
    for (std::size_t first = 0; first < densities_; first += step) {
        std::ranges::fill(seen, 0.0);
        std::ranges::fill(flux, 0.0);
        double bins = 0, summed = 0, particles = 0;
        for (std::size_t r = 0; r < replicas_; ++r) {
            for (std::size_t n = first; n < std::min(first + step, densities_); ++n) {
                const auto count = static_cast<double>(seen_[r * densities_ + n]);
                seen[r] += count;
                flux[r] += static_cast<double>(momentum_[r * densities_ + n]) / 2 / sites;
                particles += count * static_cast<double>(n);
            }
            bins += seen[r];
            summed += flux[r];
        }
        if (std::ranges::count_if(seen, [](double s) { return s > 0; }) < 2) continue;
        const double mean = summed / bins;
        double squares = 0;
        for (std::size_t r = 0; r < replicas_; ++r)
            squares += (flux[r] - mean * seen[r]) * (flux[r] - mean * seen[r]);
        const double row[] = {particles / bins / sites, mean, std::sqrt(squares) / bins,
                              bins / all};
        for (std::size_t c = 0; c < 4; ++c)
            series.values[c].push_back(row[c]);
    }
    return series;
}

void GasFlux::finish(Results& results) {
    const double sites = static_cast<double>(sampling_.bin) * sampling_.width;
    std::vector<double> fluxes, speeds, densities;
    for (std::size_t r = 0; r < replicas_; ++r) {
        double bins = 0, summed = 0, particles = 0;
        for (std::size_t n = 0; n < densities_; ++n) {
            const auto count = static_cast<double>(seen_[r * densities_ + n]);
            bins += count;
            particles += count * static_cast<double>(n);
            summed += static_cast<double>(momentum_[r * densities_ + n]) / 2;
        }
        if (bins == 0) return;
        fluxes.push_back(summed / bins / sites);
        densities.push_back(particles / bins / sites);
        if (particles > 0) speeds.push_back(summed / particles);
    }
    results.series.push_back(curve());
    results.measurements.push_back(over_samples("flux", fluxes, "1/step"));
    results.measurements.push_back(over_samples("particles_per_site", densities, "1/site"));
    if (speeds.size() == replicas_) {
        results.measurements.push_back(over_samples("mean_speed", speeds, "sites/step"));
    }
    const auto regression = slopes();
    if (2 * regression.size() < replicas_) return;
    Measurement slope = over_samples("flux_slope", regression, "sites/step");
    slope.settings = {{"window", options_.window}};
    results.measurements.push_back(slope);
}

}  // namespace crossgrain::measure
