#include "adapters/native/native_gas_code.hpp"

#include "adapters/native/gas_model.hpp"
#include "adapters/supervisor.hpp"
#include "cases/scene/model_json.hpp"
#include "native/base/errors.hpp"
#include "native/lga/ensemble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <numeric>

namespace crossgrain::adapters {
namespace {

std::unique_ptr<lga::Ensemble> ensemble(const scene::LatticeGas& scene) {
    const auto gas = gas_model(scene);
    if (scene.engine == scene::GasEngine::table) return lga::make_table_ensemble(gas);
    return lga::make_sliced_ensemble(gas,
                                     scene.word_bits.value_or(lga::best_word_width(gas.replicas)));
}

/// Lines of frames.csv, if it is to be kept.
class FrameTable {
  public:
    explicit FrameTable(const RunOptions& options) : options_(options) {
        if (!options.keep_dump) return;
        file_.open(options.directory / "frames.csv");
        file_ << "step,bin,replica,count,rests,momentum\n";
    }
    void add(const scene::GasFrame& frame) {
        if (!file_.is_open()) return;
        const auto text = [](const auto& field, std::size_t i) {
            return field.empty() ? std::string() : fmt::format("{}", field[i]);
        };
        for (std::size_t i = 0; i < frame.bins * frame.replicas; ++i) {
            file_ << fmt::format("{},{},{},{},{},{}\n", frame.step, i / frame.replicas,
                                 i % frame.replicas, text(frame.count, i), text(frame.rests, i),
                                 text(frame.momentum, i));
        }
    }
    void finish(const Supervisor& supervisor) {
        if (!options_.keep_dump) return;
        if (!file_.flush()) throw supervisor.failure("frames.csv could not be written");
    }

  private:
    const RunOptions& options_;
    std::ofstream file_;
};

class Run {
  public:
    Run(const scene::LatticeGas& scene, const RunOptions& options, const Supervisor& supervisor,
        const GasCode::Sink& sink)
        : scene_(scene), sink_(sink), supervisor_(supervisor), table_(options),
          ensemble_(ensemble(scene)) {}

    void operator()() {
        const auto& s = scene_.sampling;
        for (std::int64_t step = s.burn_in; step <= s.burn_in + s.steps; step += s.every) {
            if (!advance_to(step)) break;
            show();
        }
        table_.finish(supervisor_);
    }

  private:
    /// False when the ensemble saturated on the way and the scene says that this is a result.
    bool advance_to(std::int64_t step) {
        constexpr std::int64_t block = 100;  // steps between two looks at the clock
        while (ensemble_->step() < step) {
            supervisor_.check();
            ensemble_->advance(std::min(block, step - ensemble_->step()));
            if (ensemble_->saturated().empty()) continue;
            if (scene_.on_saturation == scene::OnSaturation::fail) throw saturation();
            show();
            return false;
        }
        supervisor_.check();
        return true;
    }

    void show() {
        const auto& s = scene_.sampling;
        ensemble_->measure(
            s.bin,
            {.count = s.fields.count, .rests = s.fields.rests, .momentum = s.fields.momentum},
            values_);
        const scene::GasFrame frame{.step = ensemble_->step(),
                                    .bins = static_cast<std::size_t>(s.bins()),
                                    .replicas = static_cast<std::size_t>(s.replicas),
                                    .count = values_.count,
                                    .rests = values_.rests,
                                    .momentum = values_.momentum,
                                    .saturated = ensemble_->saturated()};
        table_.add(frame);
        sink_(frame);
    }

    /// Names the first replica that saturated.
    [[nodiscard]] AdapterError saturation() const {
        const auto& s = scene_.sampling;
        const auto& flags = ensemble_->saturated();
        const auto replica = static_cast<std::size_t>(std::ranges::find(flags, 1) - flags.begin());
        lga::BinValues values;
        ensemble_->measure(s.bin, {.count = true, .rests = true, .momentum = false}, values);
        double count = 0, rests = 0;
        for (std::size_t i = replica; i < values.count.size(); i += flags.size()) {
            count += values.count[i];
            rests += values.rests[i];
        }
        const lga::Geometry geometry(gas_model(scene_));
        return supervisor_.failure(
            fmt::format("saturated at step {}: the particles at rest found no free site in {} of "
                        "{} replicas; in replica {} the density is {:.4g} and {:.4g} particles at "
                        "rest come on each site that can hold one; lower the density, the "
                        "injection or the dissipation",
                        ensemble_->step(), std::ranges::count(flags, 1), flags.size(), replica,
                        count / (static_cast<double>(s.length) * s.width),
                        rests / static_cast<double>(geometry.interior_sites())));
    }

    const scene::LatticeGas& scene_;
    const GasCode::Sink& sink_;
    const Supervisor& supervisor_;
    FrameTable table_;
    std::unique_ptr<lga::Ensemble> ensemble_;
    lga::BinValues values_;
};

}  // namespace

NativeGasCode::NativeGasCode(std::string version) : version_(std::move(version)) {}

Availability NativeGasCode::probe(std::stop_token /*stop*/) const {
    return {.installed = true, .version = version_, .reason = {}};
}

std::vector<std::string> NativeGasCode::features() const {
    const auto widths = lga::word_widths();
    return {"collisions: any table that conserves mass and momentum, with or without spectators",
            "gravity: rest to down, upward diagonals, up to rest; on walls or not",
            "walls: inside or outside the width; bounce back or specular",
            "relocation: origin-first, random-walk",
            "ends: periodic, open",
            fmt::format("engine: table, bit-sliced (words of up to {} bits)", widths.back()),
            fmt::format("replicas: 1 to {}", lga::max_replicas)};
}

std::optional<std::string> NativeGasCode::cannot_express(const scene::LatticeGas& scene) const {
    const auto& s = scene.sampling;
    if (s.replicas > lga::max_replicas) {
        return fmt::format("more than {} replicas in one run", lga::max_replicas);
    }
    if (scene.word_bits && scene.engine == scene::GasEngine::table) {
        return "the table engine has no words; engine = \"bit-sliced\" would be expressible";
    }
    const auto widths = lga::word_widths();
    if (scene.word_bits && std::ranges::find(widths, *scene.word_bits) == widths.end()) {
        return fmt::format("words of {} bits; on this machine {} bits would be expressible",
                           *scene.word_bits, fmt::join(widths, ", "));
    }
    // Frames hold counts in 16 bits; seven particles per site, four half sites per step of downward
    // momentum at most.
    const std::int64_t sites = std::int64_t{s.bin} * (s.width + 2);
    if (7 * sites > std::numeric_limits<std::uint16_t>::max() ||
        4 * sites > std::numeric_limits<std::int16_t>::max()) {
        return fmt::format("a bin of {} sites can hold more than 16 bits count; use shorter bins",
                           sites);
    }
    return std::nullopt;
}

std::vector<InputFile> NativeGasCode::input(const scene::LatticeGas& scene) const {
    return {{.name = "scene.json", .text = scene::to_json(scene).dump(1) + "\n"}};
}

RunCost NativeGasCode::run(const scene::LatticeGas& scene, const RunOptions& options,
                           const Sink& sink) const {
    const Supervisor supervisor(name(), options);
    try {
        Run(scene, options, supervisor, sink)();
    } catch (const CaseError& error) {
        throw supervisor.failure(error.what());
    }
    return supervisor.cost();
}

}  // namespace crossgrain::adapters
