// Where "crossgrain write" puts the inputs of runs: a directory each, and none among other files.
#pragma once

#include "adapters/run/plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace crossgrain::run {

/// "<scene>-seed<n>" per run, in their order. Scenes whose names would give one directory get a
/// digest of name and key behind it, so that no two are alike.
[[nodiscard]] std::vector<std::string>
input_directory_names(const std::vector<const PlannedRun*>& runs);

/// The input of one run and where it goes.
struct WrittenInput {
    std::filesystem::path directory;
    std::vector<adapters::InputFile> files;
};

/// Makes the directory. Throws CaseError if it cannot be made, or if it holds anything and not just
/// this input already (then also the results of a run that was started there may lie beside it).
void prepare_directory(const WrittenInput& input);

}  // namespace crossgrain::run
