#include "adapters/native/native_hopper_code.hpp"

#include "adapters/supervisor.hpp"
#include "cases/scene/model_json.hpp"
#include "native/base/errors.hpp"
#include "native/hopper/engine.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numeric>

namespace crossgrain::adapters {
namespace {

hopper::Rules rules(const scene::HopperAutomaton& scene) {
    return {.c_d = scene.c_d,
            .c_o = scene.c_o,
            .c_i = scene.c_i,
            .c_w = scene.c_w,
            .tie_tolerance = scene.reading.tie_tolerance,
            .inertia = scene.reading.inertia == scene::HopperInertia::literal
                           ? hopper::Inertia::literal
                           : hopper::Inertia::source_orientation,
            .rotation = scene.reading.rotation};
}

/// Of the run with this angle and replica; each has random numbers of its own.
hopper::Parameters parameters(const scene::HopperAutomaton& scene, std::size_t angle_index,
                              int replica) {
    const auto run =
        angle_index * static_cast<std::size_t>(scene.replicas) + static_cast<std::size_t>(replica);
    return {.outlet = scene.outlet,
            .levels = scene.levels,
            .angle = scene.angles[angle_index],
            .rules = rules(scene),
            .sweep = scene.reading.sweep == scene::HopperSweep::top_to_bottom
                         ? hopper::Sweep::top_to_bottom
                         : hopper::Sweep::bottom_to_top,
            .rows = scene.reading.rows == scene::HopperRows::zigzag ? hopper::Rows::zigzag
                                                                    : hopper::Rows::half_levels,
            .random = scene.random == scene::HopperRandom::shared_stream
                          ? hopper::RandomSource::shared_stream
                          : hopper::RandomSource::per_site,
            .seed = scene.seed,
            .run = static_cast<std::uint32_t>(run)};
}

/// Rows of dump.csv.
class FlowTable {
  public:
    FlowTable(const RunOptions& options) : path_(options.directory / "dump.csv") {
        if (!options.keep_dump) return;
        file_.open(path_);
        file_ << "angle,replica,iteration,left_the_hopper,left_reach,right_reach,moves\n";
    }
    void add(const scene::HopperFrame& frame) {
        if (!file_.is_open()) return;
        const auto gone = std::accumulate(frame.flow.begin(), frame.flow.end(), std::uint64_t{0});
        file_ << fmt::format("{},{},{},{},{},{},{}\n", frame.angle, frame.replica, frame.iteration,
                             gone, frame.left_reach, frame.right_reach, frame.moves);
    }
    void finish() {
        if (!file_.is_open() || file_.flush()) return;
        throw AdapterError({.code = "native-hopper",
                            .reason = "dump.csv could not be written",
                            .directory = path_.parent_path().string()});
    }

  private:
    std::filesystem::path path_;
    std::ofstream file_;
};

/// One angle and replica, with its flipped twin if there is one.
class Replica {
  public:
    Replica(const scene::HopperAutomaton& scene, std::size_t angle_index, int number,
            const std::shared_ptr<const hopper::CandidateTable>& table)
        : scene_(scene), angle_index_(angle_index), number_(number) {
        const auto kind = scene.engine == scene::HopperEngine::plain ? hopper::EngineKind::plain
                                                                     : hopper::EngineKind::fast;
        auto p = parameters(scene, angle_index, number);
        engine_ = hopper::make_engine(p, kind, table);
        if (scene.flipped > 0) {
            p.flipped = scene.flipped;
            twin_ = hopper::make_engine(p, kind, table);
        }
        for (const hopper::Level& level : engine_->geometry().levels()) {
            levels_.push_back({.first = level.first, .last = level.last, .offset = level.offset});
        }
    }

    void iterate() {
        engine_->advance(1);
        if (twin_) twin_->advance(1);
    }
    [[nodiscard]] std::int64_t iteration() const { return engine_->record().iterations; }

    /// Calls `use` with the present frame.
    template <class Use>
    void show(const Use& use) const {
        const hopper::Record& record = engine_->record();
        const auto state = engine_->state();
        const auto twin = twin_ ? twin_->state() : std::vector<std::uint8_t>{};
        use(scene::HopperFrame{.angle_index = angle_index_,
                               .angle = scene_.angles[angle_index_],
                               .replica = number_,
                               .iteration = record.iterations,
                               .last = record.iterations == scene_.iterations,
                               .levels = levels_,
                               .state = state,
                               .twin = twin,
                               .flow = record.flow,
                               .moves = record.moves,
                               .left_reach = record.left_reach,
                               .right_reach = record.right_reach});
    }

  private:
    const scene::HopperAutomaton& scene_;
    std::size_t angle_index_;
    int number_;
    std::unique_ptr<hopper::Engine> engine_, twin_;
    std::vector<scene::HopperLevel> levels_;
};

}  // namespace

NativeHopperCode::NativeHopperCode(std::string version) : version_(std::move(version)) {}

Availability NativeHopperCode::probe(std::stop_token /*stop*/) const {
    return {.installed = true, .version = version_, .reason = {}};
}

std::vector<std::string> NativeHopperCode::features() const {
    return {"lattice: triangular, one vertical axis; outlet of at least 2 sites, any angle below "
            "180 degrees",
            "sweep: bottom-to-top, top-to-bottom",
            "rows: half-levels, zigzag",
            "inertia: source-orientation, literal; rotation on or off; any tie tolerance",
            "energies: integers, decimal coefficients with up to 12 digits after the point",
            "random: per-site, shared-stream",
            "engine: fast, plain (the same bits)",
            "replicas, each with a twin whose initial state differs at a few nodes"};
}

std::optional<std::string>
NativeHopperCode::cannot_express(const scene::HopperAutomaton& scene) const {
    try {
        for (std::size_t i = 0; i < scene.angles.size(); ++i)
            hopper::check(parameters(scene, i, 0));
    } catch (const CaseError& error) {
        return error.what();
    }
    return std::nullopt;
}

std::vector<InputFile> NativeHopperCode::input(const scene::HopperAutomaton& scene) const {
    return {{.name = "scene.json", .text = scene::to_json(scene).dump(1) + "\n"}};
}

RunCost NativeHopperCode::run(const scene::HopperAutomaton& scene, const RunOptions& options,
                              const Sink& sink) const {
    const Supervisor supervisor(name(), options);
    FlowTable table(options);
    const auto table_of_moves =
        std::make_shared<hopper::CandidateTable>(hopper::integer_energies(rules(scene)));
    const auto use = [&](const scene::HopperFrame& frame) {
        table.add(frame);
        sink(frame);
    };
    for (std::size_t angle = 0; angle < scene.angles.size(); ++angle) {
        for (int number = 0; number < scene.replicas; ++number) {
            Replica replica(scene, angle, number, table_of_moves);
            replica.show(use);
            while (replica.iteration() < scene.iterations) {
                supervisor.check();
                replica.iterate();
                const bool last = replica.iteration() == scene.iterations;
                if (last || replica.iteration() % scene.every == 0) replica.show(use);
            }
        }
    }
    table.finish();
    return supervisor.cost();
}

}  // namespace crossgrain::adapters
