// What a call decides: which runs there are, and how they are carried out.
#pragma once

#include "adapters/run/monitor.hpp"
#include "cases/catalog/case.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::run {

struct Selection {
    catalog::Suite suite = catalog::Suite::full;
    std::vector<std::string> map_axes;     ///< keys of a failure map's sweep; empty: all
    std::vector<std::string> cases;        ///< empty: all of the suite
    std::vector<std::string> codes;        ///< empty: all
    std::optional<std::int64_t> replicas;  ///< overrides the case
    std::uint64_t seed = 1;                ///< of the first replica
};

struct Execution {
    std::filesystem::path results = "crossgrain-results";
    unsigned jobs = 0;                 ///< runs side by side; 0: one per processor
    bool fresh = false;                ///< compute again what the store already has
    std::optional<double> time_limit;  ///< wall seconds per run, overrides the case
    bool keep_dumps = false;           ///< leave inputs, logs and trajectories in <results>/runs
    std::string command;               ///< as people type it, for the history
    Monitor* monitor = &silent_monitor();
};

struct Settings : Selection, Execution {};

}  // namespace crossgrain::run
