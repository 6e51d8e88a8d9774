#include "cases/catalog/fit_file.hpp"

#include <array>

namespace crossgrain::catalog {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 5> laws{"exponent", "inverse-exponent", "outlet", "outlet-exponent",
                                      "local-slope"};

}  // namespace

std::vector<Fit> read_fits(const TomlTable& t) {
    std::vector<Fit> fits;
    for (const TomlTable& entry : t.tables("fit")) {
        Fit fit{.name = entry.name("name"),
                .law = static_cast<FitLaw>(entry.choice("law", laws)),
                .observable = entry.text("observable"),
                .along = entry.text("along")};
        if (entry.has("tangent")) fit.tangent = entry.boolean("tangent");
        fit.from = entry.optional_number("from", Range::any());
        fit.to = entry.optional_number("to", Range::any());
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
