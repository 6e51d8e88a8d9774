#include "cases/catalog/check_file.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace crossgrain::catalog {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 4> kinds{"exact", "parity", "agree", "published"};
const std::array<std::string, 6> aspects{"value",    "limit",      "order",
                                         "constant", "increasing", "decreasing"};
const std::array<std::string, 6> outcomes{"agree",           "disagree",      "undecided",
                                          "not_expressible", "not_installed", "no_reference"};

void read_expectation(const TomlTable& t, Check& check) {
    if (t.has("expect")) check.expect = outcomes[t.choice("expect", outcomes)];
    const TomlTable by_code = t.table("expect_for");
    for (const auto& code : by_code.keys()) {
        check.expect_for[code] = outcomes[by_code.choice(code, outcomes)];
    }
    check.expect_reason = t.optional_text("expect_reason").value_or("");
    const TomlTable by_variant = t.table("expect_in");
    for (const auto& pattern : by_variant.keys()) {
        check.expect_in[pattern] = outcomes[by_variant.choice(pattern, outcomes)];
    }
    const bool unusual =
        check.expect != "agree" || !check.expect_for.empty() || !check.expect_in.empty();
    if (unusual && check.expect_reason.empty()) {
        throw t.missing("expect_reason", "why something else than agreement is expected");
    }
}

void read_place(const TomlTable& t, Check& check) {
    check.at_contact_times = t.optional_number("at_contact_times", Range::positive());
    check.from = t.optional_number("from", Range::not_negative());
    check.to = t.optional_number("to", Range::positive());
    if (check.from && check.to && *check.from >= *check.to) {
        throw t.error("to", "ends the window before it begins", fmt::format("{:g}", *check.to),
                      fmt::format("more than from = {:g}", *check.from));
    }
    check.column = t.optional_text("column").value_or("");
    if (check.observable == "trajectory" && !check.at_contact_times) {
        throw t.missing("at_contact_times", "the time of the comparison");
    }
}

Check read_check(const TomlTable& t) {
    Check check;
    check.line = t.line();
    check.kind = static_cast<CheckKind>(t.choice("kind", kinds));
    check.observable = t.text("observable");
    if (t.has("aspect")) check.aspect = static_cast<Aspect>(t.choice("aspect", aspects));
    if (check.kind == CheckKind::exact || check.kind == CheckKind::published) {
        check.against = t.text("against");
    }
    if (is_trend(check.aspect)) {
        if (check.kind != CheckKind::published) {
            throw t.error("aspect", "is a trend", aspects[static_cast<std::size_t>(check.aspect)],
                          "kind = \"published\" with it");
        }
        check.along = t.text("along");
    }
    if (check.aspect == Aspect::order) check.order = t.number("order", Range::positive());
    if (t.has("variants")) check.variants = t.texts("variants");
    if (t.has("between")) {
        check.between = t.texts("between");
        if (check.kind != CheckKind::agree || check.between.size() != 2) {
            throw t.error("between", "does not fit", fmt::format("{} names", check.between.size()),
                          "two variants, in a check of kind \"agree\"");
        }
    }
    check.with = t.optional_text("with").value_or("");
    if (!check.with.empty() && (check.kind != CheckKind::agree || !check.between.empty())) {
        throw t.error("with", "does not fit", check.with,
                      "another observable, in a check of kind \"agree\" without 'between'");
    }
    if (t.has("codes")) check.codes = t.texts("codes");
    check.limit = t.number("limit", Range::positive());
    const TomlTable limits = t.table("limit_for");
    for (const auto& code : limits.keys()) {
        check.limit_for[code] = limits.number(code, Range::positive());
    }
    check.reason = t.text("reason");
    if (check.reason.empty()) throw t.error("reason", "is empty", "\"\"", "why this limit");
    read_place(t, check);
    read_expectation(t, check);
    t.reject_unknown_keys();
    return check;
}

}  // namespace

std::vector<Check> read_checks(const TomlTable& t) {
    std::vector<Check> checks;
    for (const TomlTable& entry : t.tables("check"))
        checks.push_back(read_check(entry));
    return checks;
}

}  // namespace crossgrain::catalog
