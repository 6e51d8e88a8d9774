#include "cases/observables/observables.hpp"

#include "cases/observables/estimators.hpp"
#include "cases/scene/preparation.hpp"

#include <set>

namespace crossgrain::observables {

std::vector<ObservableText> observable_texts() {
    std::vector<ObservableText> texts;
    const auto add = [&](const char* model, const auto& entries) {
        for (const auto& entry : entries)
            texts.push_back({entry.name, model, entry.measures, entry.options});
    };
    add("grains", grain_observables());
    add("lattice-gas", gas_observables());
    add("hopper-automaton", hopper_observables());
    return texts;
}

std::vector<std::string> source_folders(const catalog::Case& the_case) {
    // Which estimator an observable has, and how its options are read.
    std::set<std::string> folders{"cases/observables"};
    const auto scene = the_case.scene(0, 0, 1);
    std::visit(
        [&](const auto& own) {
            for (const auto& request : the_case.observables) {
                const auto& entry = entry_for(observables_of(own), the_case, request);
                folders.insert("cases/measure/" + entry.folder);
            }
        },
        scene);
    return {folders.begin(), folders.end()};
}

void check_observables(const catalog::Case& the_case) {
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        auto scene = the_case.scene(variant, 0, 1);
        if (auto* grains = std::get_if<scene::Scene>(&scene)) {
            *grains = scene::without_removed(std::move(*grains));
        }
        std::visit([&](const auto& own) { (void)make_estimators(the_case, own); }, scene);
    }
}

}  // namespace crossgrain::observables
