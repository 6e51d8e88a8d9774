#include "adapters/run/preparation.hpp"

#include "adapters/process/scratch_directory.hpp"
#include "adapters/registry/codes.hpp"
#include "adapters/run/store/run_claim.hpp"
#include "adapters/run/whole_file.hpp"
#include "cases/scene/preparation.hpp"
#include "cases/scene/prepared_state.hpp"
#include "cases/scene/scene_json.hpp"
#include "native/base/digest.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace crossgrain::run {
namespace {

namespace fs = std::filesystem;
using scene::InitialState;
using scene::Scene;

constexpr std::size_t longest_path = 1000;

/// The run that makes the state: one frame at its end.
Scene preparatory_run(const Scene& given) {
    Scene start = given;
    start.name.clear();
    start.steps = start.frame_every = given.preparation->steps;
    start.preparation.reset();
    return start;
}

/// No more than a state of so many grains takes. Throws std::invalid_argument for anything else.
std::string text_of_state(const fs::path& file, std::size_t grains) {
    constexpr std::size_t of_a_grain = 64, of_the_rest = 1000;  // bytes
    std::error_code error;
    if (!fs::is_regular_file(file, error)) throw std::invalid_argument("no regular file");
    if (fs::file_size(file, error) > of_a_grain * grains + of_the_rest)
        throw std::invalid_argument("larger than a state of its grains");
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A state that is not whole counts as absent, which is said: it is made again.
std::optional<InitialState> read_state(const fs::path& file, std::size_t grains, Monitor& monitor) {
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(file, missing))) return std::nullopt;
    try {
        return scene::state_from(text_of_state(file, grains), grains);
    } catch (const std::invalid_argument& error) {
        monitor.note(
            fmt::format("warning: the prepared state in {} cannot be used ({}) and is made again",
                        printable(file.string(), longest_path), printable(error.what())));
        return std::nullopt;
    }
}

/// The sole right to make a state, once nobody else is making it.
store::RunClaim claimed(const fs::path& directory, const std::string& key,
                        const std::stop_token& stop) {
    fs::create_directories(directory);
    while (true) {
        if (auto claim = store::RunClaim::take(directory, key)) return std::move(*claim);
        if (stop.stop_requested()) throw Interrupted();
        constexpr auto turn = std::chrono::milliseconds(20);
        std::this_thread::sleep_for(turn);
    }
}

}  // namespace

Preparations::Preparations(fs::path directory, const adapters::GrainCode& engine,
                           std::string version, Monitor& monitor)
    : directory_(std::move(directory)), engine_(engine), version_(std::move(version)),
      monitor_(&monitor) {}

Preparations preparations_in(const Execution& settings) {
    const auto* engine =
        dynamic_cast<const adapters::GrainCode*>(adapters::select_codes({"native-dem"}).front());
    return {fs::absolute(settings.results) / "prepared", *engine, engine->probe().version,
            *settings.monitor};
}

std::shared_ptr<const scene::AnyScene>
Preparations::prepared(std::shared_ptr<const scene::AnyScene> given, double time_limit,
                       std::stop_token stop) const {
    const auto* grains = std::get_if<Scene>(given.get());
    if (grains == nullptr || !grains->preparation) return given;
    const Scene start = preparatory_run(*grains);
    const nlohmann::json identity{{"scene", scene::to_json(start)}, {"version", version_}};
    const std::string key = sha256(identity.dump());
    const auto claim = claimed(directory_, key, stop);
    auto stored = read_state(directory_ / (key + ".json"), start.grain_count(), *monitor_);
    const InitialState state = stored ? std::move(*stored) : settled(start, key, time_limit, stop);
    return std::make_shared<const scene::AnyScene>(scene::start_of_run(*grains, state));
}

/// Positions at the end of the preparatory run, which are kept.
InitialState Preparations::settled(const Scene& start, const std::string& key, double time_limit,
                                   std::stop_token stop) const {
    if (const auto refusal = engine_.cannot_express(start)) {
        throw AdapterError({.code = engine_.name(),
                            .reason = "cannot prepare the initial state: " + *refusal,
                            .command = {},
                            .exit = {},
                            .log_tail = {},
                            .directory = {}});
    }
    const adapters::process::ScratchDirectory work(directory_, key.substr(0, 16));
    InitialState state;
    double squares = 0;
    engine_.run(start, {.directory = work.path(), .time_limit = time_limit, .stop = stop},
                [&](const scene::Frame& frame) {
                    state.x.assign(frame.x.begin(), frame.x.end());
                    state.y.assign(frame.y.begin(), frame.y.end());
                    squares =
                        std::inner_product(frame.vx.begin(), frame.vx.end(), frame.vx.begin(), 0.0);
                    squares = std::inner_product(frame.vy.begin(), frame.vy.end(), frame.vy.begin(),
                                                 squares);
                });
    const double speed = std::sqrt(squares / static_cast<double>(start.grain_count()));
    write_whole_file(directory_ / (key + ".json"), scene::text_of(state, speed));
    return state;
}

}  // namespace crossgrain::run
