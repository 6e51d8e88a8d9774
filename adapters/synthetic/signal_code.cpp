#include "adapters/synthetic/signal_code.hpp"

#include "adapters/supervisor.hpp"
#include "adapters/synthetic/coloured_noise.hpp"
#include "cases/scene/model_json.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace crossgrain::adapters {
namespace {

using scene::SyntheticSignal;

constexpr double most_bytes = 0x1p30;

double bytes_of(const SyntheticSignal& signal) {
    return 2.0 * signal.sampling.bins() * signal.sampling.replicas *
           static_cast<double>(signal.sampling.frames());
}

/// A signal of one run, shape (bins, replicas, frames).
class Counts {
  public:
    Counts(const SyntheticSignal& signal, const Supervisor& supervisor)
        : signal_(signal), bins_(static_cast<std::size_t>(signal.sampling.bins())),
          replicas_(static_cast<std::size_t>(signal.sampling.replicas)),
          frames_(static_cast<std::size_t>(signal.sampling.frames())),
          counts_(bins_ * replicas_ * frames_) {
        ColouredNoise noise(frames_, signal.exponent, signal.noise);
        for (std::size_t bin = 0; bin < bins_; ++bin) {
            const std::vector<double> carrier = mean_and_wave(bin);
            for (std::size_t replica = 0; replica < replicas_; ++replica) {
                supervisor.check();
                // Numbered so that a replica does not depend on how many there are.
                fill(carrier, noise.series(signal.seed, replica * bins_ + bin),
                     &counts_[(bin * replicas_ + replica) * frames_]);
            }
        }
    }

    void stream(const Supervisor& supervisor, const SignalCode::Sink& sink) const {
        constexpr std::size_t block = 64;  // frames that are put in order together
        const std::size_t series = bins_ * replicas_;
        std::vector<std::uint16_t> ordered(block * series);
        for (std::size_t first = 0; first < frames_; first += block) {
            supervisor.check();
            const std::size_t size = std::min(block, frames_ - first);
            for (std::size_t s = 0; s < series; ++s) {
                for (std::size_t f = 0; f < size; ++f) {
                    ordered[f * series + s] = counts_[s * frames_ + first + f];
                }
            }
            for (std::size_t f = 0; f < size; ++f) {
                sink({.step = step(first + f),
                      .bins = bins_,
                      .replicas = replicas_,
                      .count = std::span(ordered).subspan(f * series, series)});
            }
        }
    }

  private:
    [[nodiscard]] std::int64_t step(std::size_t frame) const {
        return signal_.sampling.burn_in + static_cast<std::int64_t>(frame) * signal_.sampling.every;
    }

    /// mean + amplitude cos(2 pi (x - v t) k/L) at the centre of the bin, shape (frames).
    [[nodiscard]] std::vector<double> mean_and_wave(std::size_t bin) const {
        std::vector<double> carrier(frames_, signal_.mean);
        if (signal_.wave_amplitude == 0) return carrier;
        const double x = (static_cast<double>(bin) + 0.5) * signal_.sampling.bin;
        const double k = 2 * std::numbers::pi * signal_.wave_number / signal_.sampling.length;
        for (std::size_t f = 0; f < frames_; ++f) {
            const double phase = k * (x - signal_.wave_velocity * static_cast<double>(step(f)));
            carrier[f] += signal_.wave_amplitude * std::cos(phase);
        }
        return carrier;
    }

    static void fill(std::span<const double> carrier, std::span<const double> noise,
                     std::uint16_t* counts) {
        constexpr double most = std::numeric_limits<std::uint16_t>::max();
        for (std::size_t f = 0; f < carrier.size(); ++f) {
            const double count = std::round(carrier[f] + noise[f]);
            counts[f] = static_cast<std::uint16_t>(std::clamp(count, 0.0, most));
        }
    }

    const SyntheticSignal& signal_;
    std::size_t bins_, replicas_, frames_;
    std::vector<std::uint16_t> counts_;
};

}  // namespace

SyntheticSignalCode::SyntheticSignalCode(std::string version) : version_(std::move(version)) {}

Availability SyntheticSignalCode::probe(std::stop_token /*stop*/) const {
    return {.installed = true, .version = version_, .reason = {}};
}

std::vector<std::string> SyntheticSignalCode::features() const {
    return {"Gaussian noise with power spectrum 1/f^alpha, alpha from 0 to 2, bins independent",
            "a travelling wave", "up to 2^30 bytes of counts"};
}

std::optional<std::string>
SyntheticSignalCode::cannot_express(const SyntheticSignal& signal) const {
    if (bytes_of(signal) <= most_bytes) return std::nullopt;
    return fmt::format("{:.3g} bytes of counts (2 x bins x replicas x frames), at most {:.3g}",
                       bytes_of(signal), most_bytes);
}

std::vector<InputFile> SyntheticSignalCode::input(const SyntheticSignal& signal) const {
    return {{.name = "signal.json", .text = scene::to_json(signal).dump(1) + "\n"}};
}

RunCost SyntheticSignalCode::run(const SyntheticSignal& signal, const RunOptions& options,
                                 const Sink& sink) const {
    const Supervisor supervisor(name(), options);
    Counts(signal, supervisor).stream(supervisor, sink);
    return supervisor.cost();
}

}  // namespace crossgrain::adapters
