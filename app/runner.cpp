#include "app/runner.hpp"

#include "app/catalogue/estimators.hpp"
#include "app/chart/expected_cost.hpp"
#include "app/model_runs.hpp"
#include "app/preparation.hpp"
#include "app/progress.hpp"
#include "cases/scene/lattice_guard.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>
#include <thread>

namespace crossgrain::app {
namespace {

namespace fs = std::filesystem;

std::string label(const PlannedRun& run) {
    std::string text = fmt::format("{} {}", scene::name_of(*run.scene), run.record.code);
    if (run.replica > 0) text += fmt::format(" #{}", run.replica + 1);
    if (!run.mark.empty()) text += " " + run.mark;
    return text;
}

/// A number that is none must not reach a verdict: the run has not delivered.
void require_finite(const store::RunRecord& record) {
    for (const auto& m : record.results.measurements) {
        if (std::isfinite(m.value) && std::isfinite(m.standard_error) &&
            std::isfinite(m.systematic))
            continue;
        throw TrajectoryError(fmt::format("{}: '{}' came out as {} +- {}", record.code,
                                          m.observable, m.value, m.standard_error));
    }
}

std::string directory_name(const PlannedRun& run) {
    std::string name = label(run);
    for (char& c : name) {
        if (c == '/' || c == ' ' || c == '#') c = '-';
    }
    return name;
}

/// A run's private directory, below the results so that it can be looked at; removed when the run
/// went well and no dump was asked for.
class RunDirectory {
  public:
    RunDirectory(const Settings& settings, const PlannedRun& run)
        : path_(fs::absolute(settings.results) / "runs" / directory_name(run)) {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    [[nodiscard]] const fs::path& path() const noexcept { return path_; }
    void remove() const {
        std::error_code ignored;  // left-overs do no harm
        fs::remove_all(path_, ignored);
    }

  private:
    fs::path path_;
};

class Runner {
  public:
    Runner(std::vector<PlannedRun> runs, store::Store& store, const Settings& settings,
           std::stop_token stop)
        : runs_(std::move(runs)), store_(store), settings_(settings), stop_(std::move(stop)),
          preparations_(preparations_in(settings)) {}

    RunSummary carry_out(bool compute);

  private:
    void take_from_store(bool failures);
    void compute_missing();
    void work(Progress& progress);
    void execute(PlannedRun& run, Progress& progress);
    void measure(PlannedRun& run, const RunDirectory& directory, Progress& progress);
    void keep(PlannedRun& run);

    std::vector<PlannedRun> runs_;
    store::Store& store_;
    const Settings& settings_;
    std::stop_token stop_;
    Preparations preparations_;
    std::vector<PlannedRun*> waiting_;
    std::atomic<std::size_t> next_{0};
    std::mutex store_mutex_;
    RunSummary summary_;
};

RunSummary Runner::carry_out(bool compute) {
    // What failed is tried again, unless nothing is.
    if (!settings_.fresh) take_from_store(!compute);
    if (compute) {
        compute_missing();
    } else {
        for (auto& run : runs_) {
            if (run.record.status == "planned") run.record.status = "not_run";
        }
    }
    summary_.interrupted = stop_.stop_requested();
    for (auto& run : runs_)
        summary_.records.push_back(std::move(run.record));
    return std::move(summary_);
}

void Runner::take_from_store(bool failures) {
    for (auto& run : runs_) {
        if (run.record.status != "planned") continue;
        auto stored = store_.find(run.record.key);
        if (!stored && failures) stored = store_.find_failed(run.record.key);
        if (stored) {
            // Labels may have changed since; the numbers cannot have.
            stored->case_name = run.record.case_name;
            stored->variant = run.record.variant;
            stored->rung = run.record.rung;
            stored->replica = run.record.replica;
            run.record = std::move(*stored);
            ++summary_.from_store;
        }
    }
}

void Runner::compute_missing() {
    for (auto& run : runs_) {
        if (run.record.status == "planned") waiting_.push_back(&run);
    }
    if (waiting_.empty()) return;
    // The longest runs first, so that no processor is left with one long run at the end.
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const auto* a, const auto* b) {
        return expected_seconds(*a) > expected_seconds(*b);
    });
    const double seconds =
        std::accumulate(waiting_.begin(), waiting_.end(), 0.0,
                        [](double sum, const auto* run) { return sum + expected_seconds(*run); });
    const unsigned jobs =
        settings_.jobs > 0 ? settings_.jobs : std::max(1U, std::thread::hardware_concurrency());
    Progress progress(settings_.quiet, waiting_.size(), seconds, jobs);
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::min<std::size_t>(jobs, waiting_.size()); ++i) {
        workers.emplace_back([&] { this->work(progress); });
    }
}

void Runner::work(Progress& progress) {
    for (std::size_t i = next_++; i < waiting_.size(); i = next_++) {
        if (stop_.stop_requested()) return;
        execute(*waiting_[i], progress);
    }
}

void Runner::execute(PlannedRun& run, Progress& progress) {
    auto& record = run.record;
    record.created = store::utc_now();
    std::string how;
    try {
        const RunDirectory directory(settings_, run);
        measure(run, directory, progress);
        record.status = "ok";
        how = fmt::format("{:.2f} s CPU", record.cpu_s);
        if (!settings_.keep_dumps) directory.remove();
    } catch (const Interrupted&) {
        record.status = "planned";
        return;
    } catch (const AdapterError& error) {
        record.status = "run_failed";
        record.reason = error.what();
        record.log_tail = error.details().log_tail;
        how = "run_failed: " + record.reason;
    } catch (const std::exception& error) {
        record.status = "run_failed";
        record.reason = error.what();
        how = "run_failed: " + record.reason;
    }
    keep(run);
    progress.finished(label(run), expected_seconds(run), how);
}

void Runner::measure(PlannedRun& run, const RunDirectory& directory, Progress& progress) {
    const std::string name = label(run);
    const double seconds = expected_seconds(run);
    const adapters::RunOptions options{.directory = directory.path(),
                                       .time_limit = run.time_limit,
                                       .stop = stop_,
                                       .keep_dump = settings_.keep_dumps};
    const auto ready = preparations_.prepared(run.scene, run.time_limit, stop_);
    const auto cost = with_code(*run.code, *ready, [&](const auto& code, const auto& scene) {
        const auto estimators = make_estimators(*run.owner, scene);
        auto guard = crossgrain::scene::lattice_guard(scene);
        const auto sink = [&](const auto& frame) {
            guard(frame);
            for (const auto& estimator : estimators)
                estimator->add(frame);
            progress.advanced(name, seconds, progress_of(scene, frame));
        };
        const adapters::RunCost spent = code.run(scene, options, sink);
        guard.finish();
        for (const auto& estimator : estimators)
            estimator->finish(run.record.results);
        return spent;
    });
    require_finite(run.record);
    run.record.cpu_s = cost.cpu_s;
    run.record.wall_s = cost.wall_s;
}

void Runner::keep(PlannedRun& run) {
    const std::lock_guard lock(store_mutex_);
    ++summary_.computed;
    try {
        run.record.id = store_.add(run.record);
    } catch (const store::StoreError& error) {
        // The results stay in memory and are reported; only the history is incomplete.
        if (summary_.store_error.empty()) summary_.store_error = error.what();
    }
}

}  // namespace

RunSummary carry_out(std::vector<PlannedRun> runs, store::Store& store, const Settings& settings,
                     std::stop_token stop, bool compute) {
    return Runner(std::move(runs), store, settings, std::move(stop)).carry_out(compute);
}

}  // namespace crossgrain::app
