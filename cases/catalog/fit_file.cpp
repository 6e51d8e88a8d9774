#include "cases/catalog/fit_file.hpp"

namespace crossgrain::catalog {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::Range;
using toml_input::TextKind;
using toml_input::TextRule;
using enum toml_input::Need;

}  // namespace

const toml_input::TableKeys& fit_keys() {
    static const toml_input::TableKeys keys{
        .name = "fit",
        .keys = {{"name", TextRule{TextKind::name}, "of the measurement", required},
                 {"law", ChoiceRule{all_words<FitLaw>()}, "of y over x", required},
                 {"observable", TextRule{}, "y: a measurement", required},
                 {"along", TextRule{}, "x: a key of the sweep, a setting of y, or a measurement",
                  required},
                 {"tangent", toml_input::BooleanRule{}, "x is the tangent of that, in degrees"},
                 {"from", NumberRule{Range::any()}, "least x, before any tangent"},
                 {"to", NumberRule{Range::any()}, "largest x, before any tangent"},
                 {"variants", toml_input::TextsRule{}, "names or patterns; left out: all"}}};
    return keys;
}

std::vector<Fit> read_fits(const KeyedTable& t) {
    std::vector<Fit> fits;
    for (const KeyedTable& entry : t.tables("fit")) {
        Fit fit{.name = entry.text("name"),
                .law = entry.choice<FitLaw>("law"),
                .observable = entry.text("observable"),
                .along = entry.text("along")};
        if (entry.has("tangent")) fit.tangent = entry.boolean("tangent");
        fit.from = entry.optional_number("from");
        fit.to = entry.optional_number("to");
        if (fit.from && fit.to && *fit.from >= *fit.to) {
            throw entry.error("from", "is not below 'to'", "", "from < to");
        }
        if (entry.has("variants")) fit.variants = entry.texts("variants");
        entry.reject_unknown_keys();
        fits.push_back(std::move(fit));
    }
    return fits;
}

}  // namespace crossgrain::catalog
