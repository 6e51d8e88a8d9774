// A check says what it asks, with a limit and the reason for it; an expected disagreement says why.
#include "tests/cases/catalog/case_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using catalog::Aspect;
using catalog::Check;
using catalog::CheckKind;
using catalog::Reference;
using tests::case_text;
using tests::load;
using tests::refusal_of;
using tests::refusal_with;
using tests::replaced;

namespace {

constexpr int first_line = 27;  // of the check's keys

/// The check with a further line.
Check with(const std::string& line) {
    return load(case_text + line + "\n").checks.at(0);
}

CaseErrorDetails refusal_of_line(const std::string& line) {
    return refusal_of(case_text + line + "\n");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_check_arrives_as_it_is_written) {
    const auto plain = load(case_text).checks.at(0);
    BOOST_TEST((plain.kind == CheckKind::exact));
    BOOST_TEST(plain.observable == "momentum_drift_x");
    BOOST_TEST((plain.aspect == Aspect::value));
    BOOST_TEST((plain.against == Reference{Reference::Kind::closed_form, "zero"}));
    BOOST_TEST(plain.limit == 1e-11);
    BOOST_TEST(plain.reason == "round-off");
    BOOST_TEST(plain.variants.empty());
    BOOST_TEST(plain.codes.empty());
    BOOST_TEST(plain.expect == "agree");
    BOOST_TEST(!plain.at_contact_times.has_value());
    BOOST_TEST(with("limit_for = { yade = 1e-9 }").limit_for.at("yade") == 1e-9);
    BOOST_TEST(with("codes = [\"lammps\"]").codes.at(0) == "lammps");
    BOOST_TEST(with("from = 0.0\nto = 2.5").to.value() == 2.5);
    BOOST_TEST(with("from = 0.0\nto = 2.5").from.value() == 0.0);
    BOOST_TEST(with("column = \"h\"").column == "h");
    BOOST_TEST((with("aspect = \"limit\"").aspect == Aspect::limit));
    BOOST_TEST(with("aspect = \"order\"\norder = 1.0").order == 1.0);
}

BOOST_AUTO_TEST_CASE(every_kind_is_read_and_only_those_with_a_reference_need_one) {
    const auto without = replaced(case_text, "against = \"analytic:zero\"\n", "");
    BOOST_TEST((load(replaced(without, "exact", "parity")).checks[0].kind == CheckKind::parity));
    BOOST_TEST((load(replaced(without, "exact", "agree")).checks[0].kind == CheckKind::agree));
    const auto published =
        replaced(replaced(case_text, "exact", "published"), "analytic:zero", "published:x/y");
    BOOST_TEST((load(published).checks[0].kind == CheckKind::published));
    for (const std::string kind : {"exact", "published"}) {
        const auto e = refusal_of(replaced(without, "exact", kind));
        BOOST_TEST(e.key == "check.against");
        BOOST_TEST(e.problem == "is missing");
    }
    // And a pair of codes is not held against a number.
    BOOST_TEST(refusal_of(replaced(case_text, "exact", "agree")).key == "check.against");
}

BOOST_AUTO_TEST_CASE(a_reference_says_of_which_kind_it_is) {
    const auto published = replaced(case_text, "exact", "published");
    const auto against = load(replaced(published, "analytic:zero", "published:gremaud/exponent"))
                             .checks.at(0)
                             .against;
    BOOST_TEST((against == Reference{Reference::Kind::published, "gremaud/exponent"}));
    BOOST_TEST(to_string(against) == "published:gremaud/exponent");
    BOOST_TEST(to_string(Reference{}) == "");
    for (const std::string wrong : {"zero", "published:x/y", "converged:full", "analytic:"}) {
        const auto e = refusal_of(replaced(case_text, "analytic:zero", wrong));
        BOOST_TEST(e.key == "check.against");
        BOOST_TEST(e.problem == "names no reference");
        BOOST_TEST(e.expected == "\"analytic:...\"");
        BOOST_TEST(e.line == first_line + 2);
    }
    // An exact answer is not looked up in the literature, nor a published one computed.
    BOOST_TEST(refusal_of(published).expected == "\"published:<file>/<name>\"");
}

BOOST_AUTO_TEST_CASE(a_limit_needs_its_reason) {
    const auto e = refusal_with("reason = \"round-off\"", "");
    BOOST_TEST(e.key == "check.reason");
    BOOST_TEST(e.problem == "is missing");
    BOOST_TEST(e.line == first_line - 1);
}

BOOST_AUTO_TEST_CASE(a_limit_must_be_positive) {
    for (const std::string bad : {"0", "-1e-11"}) {
        const auto e = refusal_with("1e-11", bad);
        BOOST_TEST(e.key == "check.limit");
        BOOST_TEST(e.line == first_line + 3);
        BOOST_TEST(e.problem == "is out of range");
    }
    BOOST_TEST(refusal_with("limit = 1e-11", "").key == "check.limit");
    BOOST_TEST(refusal_of_line("limit_for = { yade = 0 }").key == "check.limit_for.yade");
}

BOOST_AUTO_TEST_CASE(unknown_words_are_refused_with_the_nearest_one) {
    auto e = refusal_with("\"exact\"", "\"exactly\"");
    BOOST_TEST(e.key == "check.kind");
    BOOST_TEST(e.line == first_line);
    BOOST_TEST(e.hint == "did you mean \"exact\"?");
    e = refusal_of_line("aspect = \"limits\"");
    BOOST_TEST(e.key == "check.aspect");
    e = refusal_of_line("expect = \"disagrees\"\nexpect_reason = \"x\"");
    BOOST_TEST(e.key == "check.expect");
    BOOST_TEST(e.line == 32);
    BOOST_TEST(e.hint == "did you mean \"disagree\"?");
    e = refusal_of_line("expect_for = { yade = \"disagre\" }\nexpect_reason = \"x\"");
    BOOST_TEST(e.key == "check.expect_for.yade");
    e = refusal_of_line("limitfor = { yade = 1 }");
    BOOST_TEST(e.key == "check.limitfor");
    BOOST_TEST(e.hint == "did you mean 'limit_for'?");
}

BOOST_AUTO_TEST_CASE(expecting_anything_but_agreement_needs_a_reason) {
    for (const std::string line :
         {"expect = \"disagree\"", "expect = \"undecided\"", "expect = \"not_expressible\"",
          "expect_for = { yade = \"disagree\" }"}) {
        const auto e = refusal_of_line(line);
        BOOST_TEST(e.key == "check.expect_reason");
        BOOST_TEST(e.problem == "is missing");
        const auto check = with(line + "\nexpect_reason = \"known\"");
        BOOST_TEST(check.expect_reason == "known");
    }
    BOOST_TEST(with("expect = \"disagree\"\nexpect_reason = \"known\"").expect == "disagree");
    BOOST_TEST(with("expect_for = { yade = \"disagree\" }\nexpect_reason = \"known\"")
                   .expect_for.at("yade") == "disagree");
    BOOST_CHECK_NO_THROW((void)with("expect = \"agree\""));
}

BOOST_AUTO_TEST_CASE(an_empty_reason_is_none) {
    BOOST_TEST(refusal_of_line("expect = \"disagree\"\nexpect_reason = \"\"").key ==
               "check.expect_reason");
    BOOST_TEST(refusal_with("\"round-off\"", "\"\"").key == "check.reason");
}

BOOST_AUTO_TEST_CASE(a_comparison_of_trajectories_needs_its_time) {
    const auto text = replaced(replaced(case_text, "exact", "parity"),
                               "observable = \"momentum_drift_x\"\nagainst = \"analytic:zero\"",
                               "observable = \"trajectory\"");
    BOOST_TEST(refusal_of(text).key == "check.at_contact_times");
    BOOST_TEST(load(text + "at_contact_times = 10.0\n").checks[0].at_contact_times.value() == 10.0);
    BOOST_TEST(refusal_of(text + "at_contact_times = 0\n").problem == "is out of range");
}

BOOST_AUTO_TEST_CASE(an_order_of_convergence_needs_its_number) {
    BOOST_TEST(refusal_of_line("aspect = \"order\"").key == "check.order");
    BOOST_TEST(refusal_of_line("order = 1.0").key == "check.order");  // asked for by nobody
}

BOOST_AUTO_TEST_CASE(a_window_that_ends_before_it_begins_is_refused) {
    const auto e = refusal_of_line("from = 6.0\nto = 2.0");
    BOOST_TEST(e.key.starts_with("check."));
}

BOOST_AUTO_TEST_CASE(a_check_of_a_variant_that_does_not_exist_is_refused) {
    // It would be asked of nothing, and nobody would notice.
    const auto e = refusal_of_line("variants = [\"clip-al\"]\n[[variant]]\nname = \"clip-all\"");
    BOOST_TEST(e.key == "check.variants");
    BOOST_TEST(e.line == 26);
}
