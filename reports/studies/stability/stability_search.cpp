#include "reports/studies/stability/stability_search.hpp"

#include "adapters/registry/source_keys.hpp"

#include "adapters/process/scratch_directory.hpp"
#include "native/base/digest.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace crossgrain::studies {
namespace {

using scene::Scene;

double kinetic_energy(const scene::Frame& frame) {
    double sum = 0;
    for (std::size_t i = 0; i < frame.vx.size(); ++i)
        sum += frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i];
    return sum;
}

/// Whether the kinetic energy does not rise again from its least value, which is that of the modes
/// that grow and of those that have not died away yet.
bool is_stable(const StabilityTrial& trial, Scene packing, double dt) {
    // Undamped, a sum over hundreds of modes fluctuates by percent.
    constexpr double rise = rise_of_trial;
    constexpr std::int64_t steps = steps_of_trial, frames = 40;
    constexpr double floor = 1e-10;  // of the energy at the start; below is round-off
    packing.dt = dt;
    packing.steps = steps;
    packing.frame_every = steps / frames;
    double first = 0, least = 0, last = 0;
    const bool finished = trial.run(packing, [&](const scene::Frame& frame) {
        last = kinetic_energy(frame);
        if (frame.step == 0) first = least = last;
        least = std::min(least, last);
    });
    return finished && !(last > rise * least && last > floor * first);
}

constexpr double bracket = 1.03;      // tried first around a guess
constexpr double widening = 1.3;      // of a bracket that does not hold
constexpr double resolution = 0.005;  // at which bisection ends

/// Brackets the threshold from `guess` on, then bisects. Nothing that works: `works` stays 0.
void bisect(const StabilityTrial& trial, const Scene& packing, double guess,
            StabilityThreshold& result) {
    constexpr double hopeless = 0.05;  // of the guess
    double low = guess / bracket, high = guess * bracket;
    while (!is_stable(trial, packing, low)) {
        high = low;
        low /= widening;
        if (low < hopeless * guess) {
            result.fails = high;
            return;
        }
    }
    while (is_stable(trial, packing, high)) {
        low = high;
        high *= widening;
    }
    while (high - low > resolution * low) {
        const double middle = (low + high) / 2;
        (is_stable(trial, packing, middle) ? low : high) = middle;
    }
    result.works = low;
    result.fails = high;
}

std::string key_of(const ThresholdSearch& search) {
    Scene unnamed = search.packing;
    unnamed.name.clear();
    return sha256(nlohmann::json{{"largest stable dt of", scene::identity_json(unnamed)},
                                 {"search", {search.guess, bracket, widening, resolution}},
                                 {"code", search.code->name()},
                                 {"version", search.version},
                                 {"digest", search.digest},
                                 {"sources", adapters::source_key({"adapters/program"})}}
                      .dump());
}

/// Finds thresholds side by side; what the store has is not searched for again.
class Searches {
  public:
    Searches(std::vector<ThresholdSearch> all, const std::string& case_name,
             const run::Settings& settings, store::Store& store, std::stop_token stop)
        : all_(std::move(all)), case_name_(case_name), settings_(settings), store_(store),
          stop_(std::move(stop)) {}

    std::vector<StabilityThreshold> found() {
        std::vector<ThresholdSearch*> waiting;
        for (ThresholdSearch& search : all_)
            if (settings_.fresh || !take_from_store(search)) waiting.push_back(&search);
        if (!waiting.empty()) search_side_by_side(waiting);
        std::vector<StabilityThreshold> thresholds;
        for (const ThresholdSearch& search : all_)
            if (search.result.fails > 0) thresholds.push_back(search.result);
        return thresholds;
    }

  private:
    static constexpr const char* works = "largest_stable_dt";
    static constexpr const char* fails = "smallest_unstable_dt";

    bool take_from_store(ThresholdSearch& search) const {
        const auto stored = store_.find(key_of(search));
        if (!stored) return false;
        for (const auto& m : stored->results.measurements) {
            if (m.observable == works) search.result.works = m.value;
            if (m.observable == fails) search.result.fails = m.value;
        }
        return true;
    }

    void search_side_by_side(const std::vector<ThresholdSearch*>& waiting) {
        constexpr double seconds = 1;  // of a search, roughly
        const unsigned jobs =
            settings_.jobs > 0 ? settings_.jobs : std::max(1U, std::thread::hardware_concurrency());
        const auto progress = settings_.monitor->begin(
            waiting.size(), seconds * static_cast<double>(waiting.size()), jobs);
        std::atomic<std::size_t> next{0};
        {
            std::vector<std::jthread> workers;
            for (unsigned worker = 0; worker < jobs; ++worker) {
                workers.emplace_back([&] {
                    for (std::size_t i = next++; i < waiting.size(); i = next++) {
                        if (!search_one(*waiting[i])) return;
                        const auto& result = waiting[i]->result;
                        progress->finished(result.code + ", " + result.method, seconds,
                                           fmt::format("stable up to {:.4g}", result.works));
                    }
                });
            }
        }
        if (failure_) std::rethrow_exception(failure_);
    }

    /// False when it was stopped, or could not be done.
    bool search_one(ThresholdSearch& search) {
        try {
            if (stop_.stop_requested()) return false;
            search_and_keep(search);
            return true;
        } catch (const Interrupted&) {
            return false;
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
            return false;
        }
    }

    void search_and_keep(ThresholdSearch& search) {
        const StabilityTrial trial(*search.code,
                                   std::filesystem::absolute(settings_.results) / "runs", stop_);
        StabilityThreshold result = search.result;
        bisect(trial, search.packing, search.guess, result);
        search.result = result;
        const std::lock_guard lock(mutex_);
        (void)store_.add({.key = key_of(search),
                          .case_name = case_name_,
                          .variant = result.method,
                          .code = result.code,
                          .version = search.version,
                          .digest = search.digest,
                          .status = store::RunStatus::ok,
                          .settings_json = "{}",
                          .created = store::utc_now(),
                          .results = {.measurements = {{.observable = works,
                                                        .value = result.works,
                                                        .n = 1,
                                                        .unit = "t",
                                                        .settings = {}},
                                                       {.observable = fails,
                                                        .value = result.fails,
                                                        .n = 1,
                                                        .unit = "t",
                                                        .settings = {}}}}});
    }

    std::vector<ThresholdSearch> all_;
    std::string case_name_;
    const run::Settings& settings_;
    store::Store& store_;
    std::stop_token stop_;
    std::mutex mutex_;
    std::exception_ptr failure_;  ///< of the last search that could not be done
};

}  // namespace

bool StabilityTrial::run(const Scene& scene, const scene::FrameSink& sink) const {
    const adapters::process::ScratchDirectory directory(directory_, "stability");
    try {
        code_->run(scene, {.directory = directory.path(), .time_limit = 600, .stop = stop_}, sink);
    } catch (const AdapterError&) {
        return false;
    }
    return true;
}

std::vector<StabilityThreshold> find_thresholds(std::vector<ThresholdSearch> searches,
                                                const std::string& case_name,
                                                const run::Settings& settings, store::Store& store,
                                                std::stop_token stop) {
    return Searches(std::move(searches), case_name, settings, store, std::move(stop)).found();
}

}  // namespace crossgrain::studies
