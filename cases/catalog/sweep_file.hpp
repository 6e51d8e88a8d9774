// The [sweep] table of a case file: every combination of the listed values is a variant.
#pragma once

#include "cases/toml/toml_table.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::catalog {

/// One combination: its name ("P/dissipation=0.1"), its values as text, and as a layer of [scene].
struct SweepPoint {
    std::string name;
    std::vector<std::pair<std::string, std::string>> parameters;
    toml::table scene;
};

struct Sweep {
    std::vector<SweepPoint> points;    ///< one without name and parameters if there is no sweep
    std::map<std::string, int> lines;  ///< where each key stands in the file
};

/// `base` is the case's own [sweep], `layered` the same with [quick.sweep] laid over it. Keys with
/// texts come first, then those with numbers, each in the order of the file; the first changes
/// slowest. A key may be dotted ("contact.restitution"); its last part names it then. ["*"] stands
/// for all words of a key (scene::words_of). With `only`, numbers along other keys than these stay
/// at their first value. Throws CaseError for an empty list, a value that is neither text nor
/// number, a repeated value, or a quick key the base does not have.
[[nodiscard]] Sweep read_sweep(const toml::table* base, const toml::table* quick,
                               const std::string& file, const std::vector<std::string>& only = {});

}  // namespace crossgrain::catalog
