#include "cases/catalog/check_file.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace crossgrain::catalog {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::Range;
using toml_input::TableKeys;
using toml_input::TableRule;
using toml_input::TextRule;
using toml_input::TextsRule;
using enum toml_input::Need;

const std::vector<std::string> outcomes{"agree",           "disagree",      "undecided",
                                        "not_expressible", "not_installed", "no_reference"};

const TableKeys& limit_for_keys() {
    static const TableKeys keys{
        .name = "check.limit_for",
        .keys = {},
        .others = {{"code", NumberRule{Range::positive()}, "limit of pairs with that code"}}};
    return keys;
}

const TableKeys& expect_for_keys() {
    static const TableKeys keys{
        .name = "check.expect_for",
        .keys = {},
        .others = {{"code", ChoiceRule{outcomes}, "verdict that is expected of that code"}}};
    return keys;
}

const TableKeys& expect_in_keys() {
    static const TableKeys keys{
        .name = "check.expect_in",
        .keys = {},
        .others = {{"variant", ChoiceRule{outcomes}, "verdict that is expected there"}}};
    return keys;
}

void read_expectation(const KeyedTable& t, Check& check) {
    if (t.has("expect")) check.expect = outcomes[t.choice("expect")];
    const KeyedTable by_code = t.table("expect_for");
    for (const auto& code : by_code.names()) {
        check.expect_for[code] = outcomes[by_code.choice(code)];
    }
    check.expect_reason = t.optional_text("expect_reason").value_or("");
    const KeyedTable by_variant = t.table("expect_in");
    for (const auto& pattern : by_variant.names()) {
        check.expect_in[pattern] = outcomes[by_variant.choice(pattern)];
    }
    const bool unusual =
        check.expect != "agree" || !check.expect_for.empty() || !check.expect_in.empty();
    if (unusual && check.expect_reason.empty()) {
        throw t.missing("expect_reason", "why something else than agreement is expected");
    }
}

void read_place(const KeyedTable& t, Check& check) {
    check.at_contact_times = t.optional_number("at_contact_times");
    check.from = t.optional_number("from");
    check.to = t.optional_number("to");
    if (check.from && check.to && *check.from >= *check.to) {
        throw t.error("to", "ends the window before it begins", fmt::format("{:g}", *check.to),
                      fmt::format("more than from = {:g}", *check.from));
    }
    check.column = t.optional_text("column").value_or("");
    if (check.observable == "trajectory" && !check.at_contact_times) {
        throw t.missing("at_contact_times", "the time of the comparison");
    }
}

Check read_check(const KeyedTable& t) {
    Check check;
    check.line = t.line();
    check.kind = t.choice<CheckKind>("kind");
    check.observable = t.text("observable");
    if (t.has("aspect")) check.aspect = t.choice<Aspect>("aspect");
    if (check.kind == CheckKind::exact) {
        check.against = read_reference(t, {Reference::Kind::closed_form});
    } else if (check.kind == CheckKind::published) {
        check.against = read_reference(t, {Reference::Kind::published});
    }
    if (is_trend(check.aspect)) {
        if (check.kind != CheckKind::published) {
            throw t.error("aspect", "is a trend", to_string(check.aspect),
                          "kind = \"published\" with it");
        }
        check.along = t.text("along");
    }
    if (check.aspect == Aspect::order) check.order = t.number("order");
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
    check.limit = t.number("limit");
    const KeyedTable limits = t.table("limit_for");
    for (const auto& code : limits.names()) {
        check.limit_for[code] = limits.number(code);
    }
    check.reason = t.text("reason");
    read_place(t, check);
    read_expectation(t, check);
    t.reject_unknown_keys();
    return check;
}

}  // namespace

const TableKeys& check_keys() {
    static const TableKeys keys{
        .name = "check",
        .keys = {
            {"kind", ChoiceRule{all_words<CheckKind>()}, "of question", required},
            {"observable", TextRule{}, "a measurement, a series or \"trajectory\"", required},
            {"aspect", ChoiceRule{all_words<Aspect>()}, "what of it, default \"value\""},
            {"against", TextRule{}, "\"analytic:...\" or \"published:<file>/<name>\""},
            {"along", TextRule{}, "key of the sweep along which a trend is judged"},
            {"order", NumberRule{Range::positive()}, "of convergence that is expected"},
            {"variants", TextsRule{}, "names or patterns; left out: all"},
            {"between", TextsRule{}, "two variants that must agree in each code"},
            {"with", TextRule{}, "observable of the same code that must agree"},
            {"codes", TextsRule{.names = "code"}, "left out: all"},
            {"limit", NumberRule{Range::positive()}, "tolerance or equivalence margin", required},
            {"limit_for", TableRule{limit_for_keys}, "by code; a pair takes the larger one"},
            {"reason", TextRule{.may_be_empty = false}, "why this limit", required},
            {"at_contact_times", NumberRule{Range::positive()}, "time of a trajectory"},
            {"from", NumberRule{Range::not_negative()}, "begin of the window of a series"},
            {"to", NumberRule{Range::positive()}, "end of the window of a series"},
            {"column", TextRule{}, "of a series"},
            {"expect", ChoiceRule{outcomes}, "verdict, default \"agree\""},
            {"expect_for", TableRule{expect_for_keys}, "by code"},
            {"expect_in", TableRule{expect_in_keys}, "by variant, name or pattern"},
            {"expect_reason", TextRule{}, "why something else than agreement is expected"}}};
    return keys;
}

std::vector<Check> read_checks(const KeyedTable& t) {
    std::vector<Check> checks;
    for (const KeyedTable& entry : t.tables("check"))
        checks.push_back(read_check(entry));
    return checks;
}

}  // namespace crossgrain::catalog
