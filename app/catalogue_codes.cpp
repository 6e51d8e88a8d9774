#include "app/catalogue.hpp"
#include "app/settings.hpp"

#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "cases/toml/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace crossgrain::app {

const std::vector<std::unique_ptr<adapters::Code>>& codes() {
    static const auto all = [] {
        std::vector<std::unique_ptr<adapters::Code>> list;
        list.push_back(std::make_unique<adapters::NativeDemCode>(program_version()));
        list.push_back(std::make_unique<adapters::LammpsCode>());
        list.push_back(std::make_unique<adapters::LiggghtsCode>());
        list.push_back(std::make_unique<adapters::YadeCode>());
        return list;
    }();
    return all;
}

std::vector<const adapters::Code*> select_codes(const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const auto& code : codes()) known.push_back(code->name());
    for (const auto& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const auto near = toml_input::nearest(name, known);
        throw CaseError({.problem = "unknown code",
                         .got = fmt::format("'{}'", name),
                         .expected = fmt::format("one of {}", fmt::join(known, ", ")),
                         .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
    }
    std::vector<const adapters::Code*> selected;
    for (const auto& code : codes()) {
        if (names.empty() || std::find(names.begin(), names.end(), code->name()) != names.end()) {
            selected.push_back(code.get());
        }
    }
    return selected;
}

}  // namespace crossgrain::app
