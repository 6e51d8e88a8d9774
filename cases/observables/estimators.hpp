// From the observables a case asks for to the estimators of one run.
#pragma once

#include "cases/observables/model_observables.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace crossgrain::observables {

/// The entry of that name. Throws CaseError with the nearest name.
template <class Entry>
const Entry& entry_for(const std::vector<Entry>& entries, const catalog::Case& the_case,
                       const catalog::ObservableRequest& request) {
    std::vector<std::string> names(entries.size());
    std::ranges::transform(entries, names.begin(), &Entry::name);
    const auto found = std::find(names.begin(), names.end(), request.name);
    if (found == names.end()) {
        const auto near = toml_input::nearest(request.name, names);
        throw CaseError({.file = the_case.file,
                         .line = request.line,
                         .column = request.column,
                         .key = "observable.name",
                         .problem = "is not known",
                         .got = fmt::format("\"{}\"", request.name),
                         .expected = fmt::format("one of {}", fmt::join(names, ", ")),
                         .hint = near ? fmt::format("did you mean \"{}\"?", *near) : ""});
    }
    return entries[static_cast<std::size_t>(found - names.begin())];
}

/// Builds the estimators a case asks for. Throws CaseError for an unknown observable or option, or
/// for one that cannot measure this scene.
template <class SceneT>
auto make_estimators(const catalog::Case& the_case, const SceneT& scene) {
    using Frame = typename scene::FrameOf<SceneT>::type;
    std::vector<std::unique_ptr<measure::EstimatorOf<Frame>>> estimators;
    for (const auto& request : the_case.observables) {
        const auto& entry = entry_for(observables_of(scene), the_case, request);
        try {
            estimators.push_back(entry.make(subject_of(scene), the_case.file, request));
        } catch (const std::invalid_argument& error) {
            throw CaseError({.file = the_case.file,
                             .line = request.line,
                             .column = request.column,
                             .key = "observable",
                             .problem = fmt::format("'{}' cannot be measured: {}", request.name,
                                                    error.what())});
        } catch (const std::bad_alloc&) {
            throw CaseError(
                {.file = the_case.file,
                 .line = request.line,
                 .column = request.column,
                 .key = "observable",
                 .problem = fmt::format("'{}' needs more memory than there is", request.name)});
        }
    }
    return estimators;
}

}  // namespace crossgrain::observables
