#include "adapters/run/runner.hpp"

#include "adapters/process/scratch_directory.hpp"
#include "adapters/run/expected_cost.hpp"
#include "adapters/run/frame_measurement.hpp"
#include "adapters/run/kept_frames.hpp"
#include "adapters/run/measured_dump.hpp"
#include "adapters/run/model_runs.hpp"
#include "adapters/run/preparation.hpp"
#include "adapters/run/store/run_claim.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

namespace crossgrain::run {
namespace {

namespace fs = std::filesystem;

std::string label(const PlannedRun& run) {
    std::string text = fmt::format("{} {}", scene::name_of(*run.scene), run.record.code);
    if (run.replica > 0) text += fmt::format(" #{}", run.replica + 1);
    if (!run.mark.empty()) text += " " + run.mark;
    return text;
}

/// Leaves the directory of a run to be looked at, and its frames to be measured again.
void leave(adapters::process::ScratchDirectory& directory, const PlannedRun& run,
           const FramesIdentity& frames) {
    if (std::holds_alternative<scene::Scene>(*run.scene)) {
        record_frames(directory.path(), frames,
                      {.cpu_s = run.record.cpu_s, .wall_s = run.record.wall_s});
    }
    directory.keep();
}

class Runner {
  public:
    Runner(std::vector<PlannedRun> runs, store::Store& store, const Execution& settings,
           std::stop_token stop)
        : runs_(std::move(runs)), store_(store), settings_(settings), stop_(std::move(stop)),
          preparations_(preparations_in(settings)),
          directories_(fs::absolute(settings.results) / "runs") {}

    RunSummary carry_out(bool compute);

  private:
    [[nodiscard]] bool take_from_store(PlannedRun& run, bool failures);
    void compute_missing();
    void choose_missing();
    void work(Progress& progress);
    [[nodiscard]] bool compute_unless_claimed(PlannedRun& run, Progress& progress);
    void compute(PlannedRun& run, Progress& progress);
    [[nodiscard]] bool measure_again(PlannedRun& run, const scene::AnyScene& ready,
                                     const FramesIdentity& frames, Progress& progress);
    void measure(PlannedRun& run, const scene::AnyScene& ready, const fs::path& directory,
                 Progress& progress);
    void keep(PlannedRun& run);
    void share_results();

    std::vector<PlannedRun> runs_;
    store::Store& store_;
    const Execution& settings_;
    std::stop_token stop_;
    Preparations preparations_;
    fs::path directories_;  ///< of runs, below the results so that one can look at them
    std::vector<PlannedRun*> waiting_;
    /// Runs that are the same as one that is waiting: (copy, original).
    std::vector<std::pair<PlannedRun*, const PlannedRun*>> copies_;
    std::atomic<std::size_t> next_{0};
    std::mutex store_mutex_;
    RunSummary summary_;
};

RunSummary Runner::carry_out(bool compute) {
    for (auto& run : runs_) {
        if (run.record.status != store::RunStatus::planned || settings_.fresh) continue;
        // What failed is tried again, unless nothing is.
        (void)take_from_store(run, !compute);
    }
    if (compute) {
        compute_missing();
    } else {
        for (auto& run : runs_) {
            if (run.record.status == store::RunStatus::planned)
                run.record.status = store::RunStatus::not_run;
        }
    }
    summary_.interrupted = stop_.stop_requested();
    for (auto& run : runs_)
        summary_.records.push_back(std::move(run.record));
    return std::move(summary_);
}

/// Labels may have changed since it was stored; the numbers cannot have.
void relabel(store::RunRecord& found, const store::RunRecord& as) {
    found.case_name = as.case_name;
    found.variant = as.variant;
    found.rung = as.rung;
    found.replica = as.replica;
}

bool Runner::take_from_store(PlannedRun& run, bool failures) {
    const std::lock_guard lock(store_mutex_);
    auto stored = store_.find(run.record.key);
    if (!stored || (stored->status != store::RunStatus::ok && !failures)) return false;
    if (stored->code != run.record.code) {  // part of the key: somebody changed the row
        settings_.monitor->note(
            fmt::format("warning: a stored run of {} claims to be one of {} and is not used",
                        run.record.code, printable(stored->code)));
        return false;
    }
    relabel(*stored, run.record);
    run.record = std::move(*stored);
    ++summary_.from_store;
    return true;
}

/// What has to be computed, each key once, the longest runs first, so that no processor is left
/// with one long run at the end.
void Runner::choose_missing() {
    std::map<std::string, const PlannedRun*> by_key;
    for (auto& run : runs_) {
        if (run.record.status != store::RunStatus::planned) continue;
        const auto [first, is_new] = by_key.emplace(run.record.key, &run);
        if (is_new) {
            waiting_.push_back(&run);
        } else {
            copies_.emplace_back(&run, first->second);
        }
    }
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const auto* a, const auto* b) {
        return expected_seconds(*a) > expected_seconds(*b);
    });
}

void Runner::compute_missing() {
    store_.open();  // claims are files beside it
    for (const auto& directory : {directories_, fs::absolute(settings_.results) / "prepared"})
        adapters::process::sweep(directory);
    choose_missing();
    if (waiting_.empty()) return;
    const double seconds =
        std::accumulate(waiting_.begin(), waiting_.end(), 0.0,
                        [](double sum, const auto* run) { return sum + expected_seconds(*run); });
    const unsigned jobs =
        settings_.jobs > 0 ? settings_.jobs : std::max(1U, std::thread::hardware_concurrency());
    const auto progress = settings_.monitor->begin(waiting_.size(), seconds, jobs);
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::min<std::size_t>(jobs, waiting_.size()); ++i) {
        workers.emplace_back([&] { this->work(*progress); });
    }
    workers.clear();
    share_results();
}

void Runner::work(Progress& progress) {
    std::vector<PlannedRun*> claimed;  // by another process
    for (std::size_t i = next_++; i < waiting_.size(); i = next_++) {
        if (stop_.stop_requested()) return;
        if (!compute_unless_claimed(*waiting_[i], progress)) claimed.push_back(waiting_[i]);
    }
    for (PlannedRun* run : claimed) {
        while (!compute_unless_claimed(*run, progress)) {
            if (stop_.stop_requested()) return;
            constexpr auto turn = std::chrono::milliseconds(50);
            std::this_thread::sleep_for(turn);
        }
    }
}

/// False while another process computes the run. When that has succeeded its result is ours.
bool Runner::compute_unless_claimed(PlannedRun& run, Progress& progress) {
    try {
        const auto claim = store::RunClaim::take(settings_.results, run.record.key);
        if (!claim) return false;
        if (!settings_.fresh && take_from_store(run, false)) {
            progress.finished(label(run), expected_seconds(run), "computed by another call");
        } else {
            compute(run, progress);
        }
    } catch (const store::StoreError& error) {
        run.record.status = store::RunStatus::run_failed;
        run.record.reason = error.what();
        progress.finished(label(run), expected_seconds(run), "run_failed: " + run.record.reason);
    }
    return true;
}

void Runner::compute(PlannedRun& run, Progress& progress) {
    auto& record = run.record;
    record.created = store::utc_now();
    std::optional<adapters::process::ScratchDirectory> directory;
    const auto fail = [&](std::string reason, std::string log_tail = {}, bool timed_out = false) {
        record.status = timed_out ? store::RunStatus::timed_out : store::RunStatus::run_failed;
        record.reason = std::move(reason);
        record.log_tail = std::move(log_tail);
        if (directory) directory->keep();  // the error names it
    };
    try {
        const auto ready = preparations_.prepared(run.scene, run.time_limit, stop_);
        const FramesIdentity frames{frames_key(run, *ready), record.code, record.version};
        if (settings_.fresh || !measure_again(run, *ready, frames, progress)) {
            directory.emplace(directories_, frames_directory_stem(scene::name_of(*run.scene),
                                                                  frames, run.replica));
            measure(run, *ready, directory->path(), progress);
            if (settings_.keep_dumps) leave(*directory, run, frames);
        }
        record.status = store::RunStatus::ok;
    } catch (const Interrupted&) {
        record.status = store::RunStatus::planned;
        return;
    } catch (const AdapterError& error) {
        fail(error.what(), error.details().log_tail, error.details().timed_out);
    } catch (const std::bad_alloc&) {
        fail("there is not enough memory for this run");
    } catch (const std::exception& error) {
        fail(printable(error.what()));
    }
    keep(run);
    progress.finished(label(run), expected_seconds(run),
                      record.status != store::RunStatus::ok ? "run_failed: " + record.reason
                      : record.measured_again               ? "measured again from kept frames"
                                              : fmt::format("{:.2f} s CPU", record.cpu_s));
}

/// False if there are no frames of an earlier run, or none that can be measured.
bool Runner::measure_again(PlannedRun& run, const scene::AnyScene& ready,
                           const FramesIdentity& frames, Progress& progress) {
    const auto* scene = std::get_if<scene::Scene>(&ready);
    if (scene == nullptr) return false;
    const auto kept = find_frames(directories_, frames, *settings_.monitor, stop_);
    if (!kept) return false;
    const std::string name = label(run);
    const double seconds = expected_seconds(run);
    const auto passed = [&](const auto& frame) {
        progress.advanced(name, seconds, progress_of(*scene, frame));
    };
    try {
        run.record.results = measure_frames(*run.owner, *scene, kept->dump, passed, stop_);
    } catch (const Interrupted&) {
        throw;
    } catch (const std::runtime_error& error) {  // the frames' fault, or that of who measures them
        settings_.monitor->note(frames_refusal(kept->dump.parent_path(), error.what()));
        return false;
    }
    run.record.cpu_s = kept->cost.cpu_s;
    run.record.wall_s = kept->cost.wall_s;
    run.record.measured_again = true;
    return true;
}

void Runner::measure(PlannedRun& run, const scene::AnyScene& ready, const fs::path& directory,
                     Progress& progress) {
    const std::string name = label(run);
    const double seconds = expected_seconds(run);
    const adapters::RunOptions options{.directory = directory,
                                       .time_limit = run.time_limit,
                                       .stop = stop_,
                                       .keep_dump = settings_.keep_dumps};
    const auto cost = with_code(*run.code, ready, [&](const auto& code, const auto& scene) {
        FrameMeasurement measurement(*run.owner, scene);
        const auto sink = [&](const auto& frame) {
            measurement.add(frame);
            progress.advanced(name, seconds, progress_of(scene, frame));
        };
        const adapters::RunCost spent = code.run(scene, options, sink);
        run.record.results = measurement.finish();
        return spent;
    });
    run.record.cpu_s = cost.cpu_s;
    run.record.wall_s = cost.wall_s;
}

void Runner::keep(PlannedRun& run) {
    const std::lock_guard lock(store_mutex_);
    ++(run.record.measured_again ? summary_.measured_again : summary_.computed);
    try {
        run.record.id = store_.add(run.record);
    } catch (const store::StoreError& error) {
        // The results stay in memory and are reported; only the history is incomplete.
        if (summary_.store_error.empty()) summary_.store_error = error.what();
    }
}

/// Runs that are the same have the same result.
void Runner::share_results() {
    for (const auto& [copy, original] : copies_) {
        store::RunRecord record = original->record;
        relabel(record, copy->record);
        copy->record = std::move(record);
    }
}

}  // namespace

RunSummary carry_out(std::vector<PlannedRun> runs, store::Store& store, const Execution& settings,
                     std::stop_token stop, bool compute) {
    return Runner(std::move(runs), store, settings, std::move(stop)).carry_out(compute);
}

}  // namespace crossgrain::run
