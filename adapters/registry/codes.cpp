#include "adapters/registry/codes.hpp"

#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/native/native_gas_code.hpp"
#include "adapters/native/native_hopper_code.hpp"
#include "adapters/registry/program_version.hpp"
#include "adapters/registry/source_keys.hpp"
#include "adapters/synthetic/signal_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "cases/toml/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace crossgrain::adapters {

namespace {

struct Entry {
    std::unique_ptr<Code> code;
    std::vector<std::string> sources;  ///< folders that decide its frames, with what they include
    TypicalCost cost;
};

/// Our own engines are known by their sources.
template <class Engine>
Entry engine(const std::vector<std::string>& sources, double rate = TypicalCost().rate) {
    constexpr std::size_t shown = 8;
    return {std::make_unique<Engine>(release_version() + " (engine " +
                                     source_key(sources).substr(0, shown) + ")"),
            sources,
            {.start_s = 0, .rate = rate}};
}

const std::vector<Entry>& entries() {
    static const auto all = [] {
        std::vector<Entry> list;
        list.push_back(
            engine<NativeDemCode>({"adapters/native", "native/dem", "native/friction"}, 6e7));
        list.push_back(engine<NativeGasCode>({"adapters/native", "native/lga"}, 2.5e9));
        list.push_back(engine<NativeHopperCode>({"adapters/native", "native/hopper"}, 5e7));
        list.push_back(engine<SyntheticSignalCode>({"adapters/synthetic"}));
        list.push_back({std::make_unique<LammpsCode>(), {"adapters/lammps"}, {0.2, 1.1e7}});
        list.push_back({std::make_unique<LiggghtsCode>(), {"adapters/liggghts"}, {0.2, 5e6}});
        list.push_back({std::make_unique<YadeCode>(), {"adapters/yade"}, {0.9, 2e6}});
        // tools/new.sh code: codes go above this line
        return list;
    }();
    return all;
}

}  // namespace

const std::vector<const Code*>& codes() {
    static const auto all = [] {
        std::vector<const Code*> list;
        for (const auto& entry : entries())
            list.push_back(entry.code.get());
        return list;
    }();
    return all;
}

TypicalCost typical_cost(const std::string& name) {
    for (const auto& entry : entries()) {
        if (entry.code->name() == name) return entry.cost;
    }
    return {};
}

std::string code_source_key(const std::string& name) {
    for (const auto& entry : entries()) {
        if (entry.code->name() == name) return source_key(entry.sources);
    }
    throw std::invalid_argument("no code is named " + name);
}

void require_code(const std::string& name, CaseErrorDetails where) {
    std::vector<std::string> known;
    for (const auto& code : codes())
        known.push_back(code->name());
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const auto near = toml_input::nearest(name, known);
    where.problem = where.key.empty() ? "unknown code" : "names an unknown code";
    where.got = fmt::format("'{}'", name);
    where.expected = fmt::format("one of {}", fmt::join(known, ", "));
    where.hint = near ? fmt::format("did you mean '{}'?", *near) : "";
    throw CaseError(where);
}

std::vector<const Code*> select_codes(const std::vector<std::string>& names) {
    for (const auto& name : names)
        require_code(name, {});
    std::vector<const Code*> selected;
    for (const auto& code : codes()) {
        if (names.empty() || std::find(names.begin(), names.end(), code->name()) != names.end()) {
            selected.push_back(code);
        }
    }
    return selected;
}

}  // namespace crossgrain::adapters
