#include "adapters/run/written_input.hpp"

#include "native/base/digest.hpp"
#include "native/base/errors.hpp"
#include "native/base/file_stem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>

namespace crossgrain::run {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool holds(const WrittenInput& input) {
    return std::ranges::all_of(input.files, [&](const auto& file) {
        const auto path = input.directory / file.name;
        return fs::is_regular_file(path) && content_of(path) == file.text;
    });
}

std::string stem(const PlannedRun& run) {
    return fmt::format("{}-seed{}", file_stem({scene::name_of(*run.scene)}), run.record.seed);
}

}  // namespace

std::vector<std::string> input_directory_names(const std::vector<const PlannedRun*>& runs) {
    std::map<std::string, int> uses;
    for (const auto* run : runs)
        ++uses[stem(*run)];
    std::vector<std::string> names;
    for (const auto* run : runs) {
        names.push_back(stem(*run));
        if (uses[names.back()] > 1)
            names.back() +=
                fmt::format("-{:.8}", sha256(scene::name_of(*run->scene) + run_key(*run)));
    }
    return names;
}

void prepare_directory(const WrittenInput& input) {
    std::error_code error;
    fs::create_directories(input.directory, error);
    if (error) {
        throw CaseError({.file = input.directory.string(),
                         .problem = "cannot be created",
                         .got = error.message(),
                         .expected = "a directory that can be written"});
    }
    if (fs::is_empty(input.directory, error) || (!error && holds(input))) return;
    if (error) {
        throw CaseError({.file = input.directory.string(),
                         .problem = "cannot be read",
                         .got = error.message(),
                         .expected = "an empty directory, or the same input"});
    }
    throw CaseError({.file = input.directory.string(),
                     .problem = "holds other files than the input to be written",
                     .expected = "an empty directory, or the same input",
                     .hint = "remove it or choose another --out"});
}

}  // namespace crossgrain::run
